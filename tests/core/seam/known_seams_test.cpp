// SPDX-License-Identifier: GPL-3.0-or-later
// Garments whose seams are known: welded ones cut into their panels, and panels apart.
#include <fstream>
#include <map>
#include <numeric>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/io/soup.h"
#include "core/seam/find_seams.h"
#include "core/toile/pipeline.h"
#include "tests/core/seam/seam_shapes.h"
#include "tests/core/support/sewn_sample.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

using PanelPair = std::pair<int, int>;

nlohmann::json readJson(const std::filesystem::path& path) {
    std::ifstream stream(path);
    return nlohmann::json::parse(stream);
}

/// The panels of a welded file as pieces, in the order of the truth, positions as in the file. A
/// corner's texture vertex tells the two sides of a panel that is sewn to itself apart.
Pieces cutIntoPanels(const PolygonSoup& soup, const nlohmann::json& truth) {
    struct Panel {
        std::vector<int> corners, source;
        std::map<int, int> index;  // of each texture vertex
    };
    std::vector<Panel> panels(truth["panels"].size());
    for (int f = 0; f < soup.faceCount(); ++f) {
        Panel& panel = panels[truth["face_panel"][f].get<std::size_t>()];
        for (int c = soup.faceStart[f]; c < soup.faceStart[f + 1]; ++c) {
            const auto [at, isNew] =
                panel.index.emplace(soup.cornerUvs[c], static_cast<int>(panel.source.size()));
            if (isNew) {
                panel.source.push_back(soup.corners[c]);
            }
            panel.corners.push_back(at->second);
        }
    }
    Pieces pieces;
    for (std::size_t p = 0; p < panels.size(); ++p) {
        MeshArrays mesh;
        mesh.F = Eigen::Map<Triangles>(panels[p].corners.data(),
                                       static_cast<Eigen::Index>(panels[p].corners.size() / 3), 3);
        mesh.V.resize(static_cast<Eigen::Index>(panels[p].source.size()), 3);
        for (std::size_t v = 0; v < panels[p].source.size(); ++v) {
            mesh.V.row(static_cast<Eigen::Index>(v)) = soup.positions[panels[p].source[v]];
        }
        auto piece =
            std::make_shared<Piece>(makePiece(truth["panels"][p]["name"], std::move(mesh)));
        EXPECT_FALSE(piece->defect) << (piece->defect ? sentence(*piece->defect) : "");
        piece->sourceVertex = std::move(panels[p].source);
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

/// Sewn length per pair of panels.
std::map<PanelPair, double> known(const nlohmann::json& truth) {
    std::map<PanelPair, double> sums;
    for (const auto& seam : truth["seams"]) {
        const int a = seam["panels"][0], b = seam["panels"][1];
        sums[{std::min(a, b), std::max(a, b)}] += seam["length_3d"].get<double>();
    }
    return sums;
}

/// Compares sewn lengths per pair of panels. `panel`: number of each piece in the truth; `unit`:
/// the graph's mm in one unit of the truth, which has five decimals. The truth leaves out lines of
/// three layers: there the graph has as much more as it has stacked.
void expectKnown(const SeamGraph& graph, const std::vector<int>& panel, const nlohmann::json& truth,
                 double unit) {
    std::map<PanelPair, double> got;
    std::size_t seams = 0;
    double layered = 0;
    for (const Seam& seam : graph.seams) {
        if (seam.kind == SeamKind::Free) {
            continue;
        }
        if (seam.stacked) {
            layered += seam.length3d[0] / unit;
            continue;
        }
        got[std::minmax(panel[seam.left.piece], panel[seam.right.piece])] +=
            seam.length3d[0] / unit;
        ++seams;
    }
    EXPECT_EQ(layered > 0, truth["edges_with_more_than_two_faces"] > 0);
    const auto wanted = known(truth);
    EXPECT_EQ(got.size(), wanted.size());
    double more = 0;
    for (const auto& [pair, length] : wanted) {
        more += got[pair] - length;
        if (layered == 0) {
            EXPECT_NEAR(got[pair], length, 1e-4) << pair.first << " / " << pair.second;
        }
    }
    EXPECT_NEAR(more, layered, 1e-3);
    EXPECT_EQ(seams, truth["seams"].size());
}

/// What is sewn is as long as the edges that pieces have in common: between two pieces, and where
/// more meet in an edge, over all of them.
void expectSharedLengths(const SeamGraph& graph, const Pieces& pieces) {
    std::map<PanelPair, std::vector<std::pair<int, double>>> owners;  // by the ends of an edge
    for (int p = 0; p < static_cast<int>(pieces.size()); ++p) {
        const Piece& piece = *pieces[static_cast<std::size_t>(p)];
        for (std::size_t k = 0; k < piece.boundary.size(); ++k) {
            const int u = piece.boundary[k], v = piece.boundary[(k + 1) % piece.boundary.size()];
            const PanelPair ends = std::minmax({piece.sourceVertex[u], piece.sourceVertex[v]});
            owners[ends].emplace_back(p, (piece.mesh.V.row(u) - piece.mesh.V.row(v)).norm());
        }
    }
    std::map<PanelPair, double> shared, sewn;
    double all = 0;
    bool isLayered = false;
    for (const auto& [ends, list] : owners) {
        if (list.size() > 1) {
            shared[std::minmax({list[0].first, list[1].first})] += list[0].second;
            all += static_cast<double>(list.size() - 1) * list[0].second;
            isLayered |= list.size() > 2;
        }
    }
    for (const Seam& seam : graph.seams) {
        if (seam.kind != SeamKind::Free) {
            sewn[std::minmax({seam.left.piece, seam.right.piece})] += seam.length3d[0];
            all -= seam.length3d[0];
        }
    }
    EXPECT_NEAR(all, 0, 1e-6);
    if (!isLayered) {
        EXPECT_EQ(sewn.size(), shared.size());
        for (const auto& [pair, length] : shared) {
            EXPECT_NEAR(sewn[pair], length, 1e-6) << pair.first << " / " << pair.second;
        }
    }
}

class WeldedSeams : public testing::TestWithParam<const char*> {};

TEST_P(WeldedSeams, AreTheTrueOnes) {
    const test::TemporaryFolder folder;
    const std::string base = test::garmentWithTruth(GetParam(), folder.path()).string();
    const std::filesystem::path mesh = base + ".obj", truthFile = base + ".truth.json";
    TOILE_NEEDS_SHARED(mesh);
    TOILE_NEEDS_SHARED(truthFile);
    Progress progress;
    const auto soup = readSoup(mesh, progress);
    ASSERT_TRUE(soup);
    const auto truth = readJson(truthFile);
    const Pieces pieces = cutIntoPanels(*soup, truth);
    const SeamGraph graph = findSeams(pieces);
    test::expectValid(graph, pieces);
    std::vector<int> panel(pieces.size());
    std::iota(panel.begin(), panel.end(), 0);
    expectKnown(graph, panel, truth, 1);
    expectSharedLengths(graph, pieces);
    EXPECT_TRUE(graph.notes.empty());  // nothing is guessed
    for (const Seam& seam : graph.seams) {
        if (seam.kind != SeamKind::Free) {
            EXPECT_NEAR(seam.length3d[0], seam.length3d[1], 1e-9) << seam.name;
        }
    }
    // Without the shared vertices, the coinciding positions must say the same.
    Pieces apart;
    for (const auto& piece : pieces) {
        auto copy = std::make_shared<Piece>(*piece);
        copy->sourceVertex.clear();
        apart.push_back(std::move(copy));
    }
    EXPECT_EQ(test::summary(findSeams(apart), 1, 6), test::summary(graph, 1, 6));
}

const auto kSamples = testing::Values("samples/tshirt", "samples/bodice", "samples/trousers",
                                      "samples/cap", "samples/skirt");

INSTANTIATE_TEST_SUITE_P(Samples, WeldedSeams, kSamples);
INSTANTIATE_TEST_SUITE_P(Shared, WeldedSeams,
                         testing::Values("tshirt", "tee_sim", "longsleeve", "dress",
                                         "wetsuit_patches", "arcsim/tshirt", "arcsim/pants3",
                                         "polo"));

class SeamsOfPanelsApart : public testing::TestWithParam<const char*> {};

TEST_P(SeamsOfPanelsApart, AreTheTrueOnes) {
    const test::TemporaryFolder folder;
    const std::string base = test::garmentWithTruth(GetParam(), folder.path()).string();
    const std::filesystem::path mesh = base + "_pieces.obj", truthFile = base + ".truth.json";
    TOILE_NEEDS_SHARED(mesh);
    TOILE_NEEDS_SHARED(truthFile);
    Progress progress;
    const auto garment = loadGarment({mesh}, {.unit = LengthUnit::Centimetre}, progress);
    ASSERT_TRUE(garment);
    const auto truth = readJson(truthFile);
    ASSERT_EQ(garment->pieces.size(), truth["panels"].size());
    std::vector<int> panel;
    for (const auto& piece : garment->pieces) {
        const Eigen::RowVector3d middle = piece->mesh.V.colwise().mean() / 10;
        int nearest = 0;
        double least = 1e300;
        for (const auto& candidate : truth["panels"]) {
            const auto& c = candidate["centroid_3d"];
            const double d =
                (Eigen::RowVector3d(c[0].get<double>(), c[1].get<double>(), c[2].get<double>()) -
                 middle)
                    .norm();
            if (candidate["faces"] == piece->mesh.F.rows() && d < least) {
                least = d;
                nearest = candidate["id"];
            }
        }
        panel.push_back(nearest);
    }
    const SeamGraph graph = findSeams(garment->pieces);
    test::expectValid(graph, garment->pieces);
    expectKnown(graph, panel, truth, 10);
}

INSTANTIATE_TEST_SUITE_P(Samples, SeamsOfPanelsApart, kSamples);
INSTANTIATE_TEST_SUITE_P(Shared, SeamsOfPanelsApart, testing::Values("tee_sim", "polo"));

struct Counted {
    const char* file;
    std::size_t seams, darts;
};

/// Garments without a list of seams, whose number is known from looking at them.
class CountedSeams : public testing::TestWithParam<Counted> {};

TEST_P(CountedSeams, AreAllThere) {
    const auto mesh = test::dataFile(GetParam().file);
    TOILE_NEEDS_SHARED(mesh);
    Progress progress;
    const auto garment = loadGarment({mesh}, {}, progress);
    ASSERT_TRUE(garment);
    const SeamGraph graph = findSeams(garment->pieces);
    test::expectValid(graph, garment->pieces);
    EXPECT_EQ(test::only(graph, SeamKind::Seam).size(), GetParam().seams);
    EXPECT_EQ(test::only(graph, SeamKind::Dart).size(), GetParam().darts);
    EXPECT_TRUE(test::only(graph, SeamKind::Fold).empty());
}

// Pieces that are sewn to themselves end to end count among the seams.
INSTANTIATE_TEST_SUITE_P(Samples, CountedSeams,
                         testing::Values(Counted{"samples/tshirt.obj", 14, 0},
                                         Counted{"samples/bodice.obj", 11, 0},
                                         Counted{"samples/trousers.obj", 11, 0},
                                         Counted{"samples/cap.obj", 10, 0},
                                         Counted{"samples/skirt.obj", 14, 0}));

// Two darts a panel and four side seams; panels placed with gaps of some millimetres.
INSTANTIATE_TEST_SUITE_P(Shared, CountedSeams,
                         testing::Values(Counted{"garments/skirt_clo.obj", 4, 8},
                                         Counted{"garments/arcsim/tshirtw.obj", 12, 0}));

}  // namespace
}  // namespace toile
