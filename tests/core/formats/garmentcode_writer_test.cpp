// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/garmentcode/garmentcode_writer.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/formats/formats.h"
#include "core/formats/garmentcode/garmentcode_reader.h"
#include "core/toile/pipeline.h"
#include "tests/core/pattern/notched_garments.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/symmetry/mirror_shapes.h"

namespace toile {
namespace {

/// A garment with its pattern, which a source refers to.
struct Made {
    Garment garment;
    PieceResults results;
    LaidOutPattern laid;

    Made(Garment from, const LineSettings& lines) : garment(std::move(from)) {
        Progress progress;
        results = flattenGarment(garment, {}, progress, 0, lines);
        laid = cutAndPlace(makePattern(garment, results, lines));
    }

    ExportSource source() const { return {garment, results, laid}; }
};

LineSettings fairSettings() {
    LineSettings lines;
    lines.fairing = Fairing{};
    lines.trueBelow = kProposedTrueing;
    return lines;
}

Made madeFrom(const std::string& name, const LineSettings& lines) {
    return {name == "tube" ? test::tube4(test::draped) : test::garmentOf(name), lines};
}

int sewnSeams(const Garment& garment) {
    return static_cast<int>(std::ranges::count_if(garment.seams.seams, [](const Seam& seam) {
        return seam.kind != SeamKind::Free && !seam.stacked && seam.left.loop == 0 &&
               seam.right.loop == 0;
    }));
}

class GarmentCodeWriter : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        if (std::string(GetParam()) != "tube") {
            TOILE_NEEDS_SHARED(test::dataFile(GetParam()));
        }
    }
};

TEST_P(GarmentCodeWriter, WritesWhatReadsBackWithEverySeam) {
    for (const LineSettings& lines : {LineSettings{}, fairSettings()}) {
        const Made made = madeFrom(GetParam(), lines);
        const std::string bytes = writeGarmentCode(sewnPanels(made.source()));
        const auto read = readBackGarmentCode(bytes, made.laid.wholePattern);
        ASSERT_TRUE(read) << sentence(read.error());
        EXPECT_EQ(read->pieces, static_cast<int>(made.garment.pieces.size()));
        EXPECT_EQ(read->seams, sewnSeams(made.garment));
        EXPECT_LT(read->largest, kReadBackLengths * 2);
        EXPECT_EQ(bytes, writeGarmentCode(sewnPanels(made.source())));
    }
}

TEST_P(GarmentCodeWriter, StitchesOneEdgeToOneAtTheSameSharesOfBothSides) {
    const Made made = madeFrom(GetParam(), fairSettings());
    const SewnPanels panels = sewnPanels(made.source());
    const auto edgeOf = [&panels](const SewnEdges::Side& side) -> const PanelEdge& {
        return panels.panels[static_cast<std::size_t>(side.panel)]
            .edges[static_cast<std::size_t>(side.edge)];
    };
    std::set<std::pair<int, int>> sewn;
    for (const SewnEdges& stitch : panels.stitches) {
        for (const auto& side : stitch.sides) {
            EXPECT_TRUE(sewn.emplace(side.panel, side.edge).second) << "sewn twice";
            EXPECT_GT(edgeOf(side).length, 0);
        }
    }
    // The two sides of a seam differ by its ease alone, which these garments have little of.
    double first = 0, second = 0;
    for (const SewnEdges& stitch : panels.stitches) {
        first += edgeOf(stitch.sides[0]).length;
        second += edgeOf(stitch.sides[1]).length;
    }
    EXPECT_NEAR(first, second, 0.05 * first);
}

TEST_P(GarmentCodeWriter, ClosesEveryPanel) {
    const Made made = madeFrom(GetParam(), fairSettings());
    for (const SewnPanel& panel : sewnPanels(made.source()).panels) {
        for (std::size_t k = 0; k < panel.edges.size(); ++k) {
            const CubicCurve& curve = panel.edges[k].curve;
            const CubicCurve& next = panel.edges[(k + 1) % panel.edges.size()].curve;
            EXPECT_LT((curve.end - next.start).norm(), 1e-6) << panel.name << ' ' << k;
            EXPECT_GT((curve.end - curve.start).norm(), 0.1 * panel.edges[k].length);
        }
        EXPECT_NEAR(panel.turn.determinant(), 1, 1e-9);
        EXPECT_LT((panel.turn * panel.turn.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(Garments, GarmentCodeWriter,
                         testing::Values("tube", "samples/tshirt.obj", "samples/cap.obj",
                                         "garments/polo.obj", "garments/skirt_clo.obj"));

TEST(GarmentCodeWriter, PlacesFlatPiecesWhereTheyAre) {
    // A rectangle in a plane of its own: turned about all three axes.
    MeshArrays mesh;
    mesh.V.resize(4, 3);
    mesh.V << 0, 0, 0, 300, 0, 0, 300, 200, 0, 0, 200, 0;
    mesh.F.resize(2, 3);
    mesh.F << 0, 1, 2, 0, 2, 3;
    for (auto row : mesh.V.rowwise()) {
        row = test::moved(row.transpose()).transpose();
    }
    const Points3 V = mesh.V;
    const Made made(test::plane({mesh}), {});
    const auto code = readGarmentCode(writeGarmentCode(sewnPanels(made.source())));
    ASSERT_TRUE(code);
    const GarmentCodePanel& panel = code->panels.front();
    const Eigen::Vector3d turns = panel.rotation * kDegree;
    const Eigen::Matrix3d turn = (Eigen::AngleAxisd(turns.z(), Eigen::Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(turns.y(), Eigen::Vector3d::UnitY()) *
                                  Eigen::AngleAxisd(turns.x(), Eigen::Vector3d::UnitX()))
                                     .toRotationMatrix();
    for (const GarmentCodeEdge& edge : panel.edges) {
        const Eigen::Vector2d corner = edge.curves.front().start;
        const Eigen::Vector3d place =
            panel.translation + turn * Eigen::Vector3d(corner.x(), corner.y(), 0);
        EXPECT_LT((V.rowwise() - place.transpose()).rowwise().norm().minCoeff(), 1e-3);
    }
}

TEST(GarmentCodeWriter, NoticesWhatIsNotInTheFile) {
    const Made made = madeFrom("tube", fairSettings());
    const std::string bytes = writeGarmentCode(sewnPanels(made.source()));
    const auto broken = [&](const auto& change) {
        auto json = nlohmann::json::parse(bytes);
        change(json["pattern"]);
        return !readBackGarmentCode(json.dump(), made.laid.wholePattern).ok();
    };
    EXPECT_FALSE(broken([](auto&) {}));
    EXPECT_TRUE(broken([](auto& pattern) { pattern["stitches"].erase(0); }));
    EXPECT_TRUE(broken([](auto& pattern) {
        auto& vertex = pattern["panels"]["front"]["vertices"][1][1];
        vertex = vertex.template get<double>() + 0.01;
    }));
    EXPECT_TRUE(broken([](auto& pattern) { pattern["panels"].erase("left"); }));
    EXPECT_TRUE(broken([](auto& pattern) {
        std::swap(pattern["stitches"][0][1], pattern["stitches"].back()[1]);
    }));
}

TEST(GarmentCodeWriter, IsAFormatOfItsOwnLongEnding) {
    EXPECT_EQ(formatOf("a/dress.specification.json")->id, FormatId::GarmentCode);
    EXPECT_EQ(formatOf("a/dress.json")->id, FormatId::Report);
}

/// Every key that ours has is there in theirs with the same type, and theirs in ours.
void expectAlike(const nlohmann::json& ours, const nlohmann::json& theirs,
                 const std::string& place) {
    if (ours.is_object() && theirs.is_object()) {
        for (const auto& [key, value] : ours.items()) {
            if (theirs.contains(key)) {
                expectAlike(value, theirs[key], place + "." + key);
            } else {
                ADD_FAILURE() << place << "." << key << " is ours alone";
            }
        }
        return;
    }
    EXPECT_TRUE(ours.type() == theirs.type() || (ours.is_number() && theirs.is_number())) << place;
    if (ours.is_array() && !ours.empty() && !theirs.empty()) {
        expectAlike(ours[0], theirs[0], place + "[0]");
    }
}

TEST(GarmentCodeWriter, HasTheKeysAndTypesOfTheFormatsOwnFiles) {
    const auto path = test::dataFile("patterns/gc_hoody.specification.json");
    TOILE_NEEDS_SHARED(path);
    auto theirs = nlohmann::json::parse(*readFile(path));
    const Made made = madeFrom("tube", fairSettings());
    auto ours = nlohmann::json::parse(writeGarmentCode(sewnPanels(made.source())));
    // Panels have names of their own, and edges may be curved or not.
    const auto firstOf = [](nlohmann::json& panels) {
        nlohmann::json panel = *panels.begin();
        nlohmann::json curved;
        for (const auto& edge : panel["edges"]) {
            curved =
                edge.contains("curvature") && edge["curvature"]["type"] == "cubic" ? edge : curved;
        }
        EXPECT_FALSE(curved.is_null());
        panel["edges"] = nlohmann::json::array({curved});
        panels = nlohmann::json::object({{"panel", panel}});
    };
    firstOf(ours["pattern"]["panels"]);
    firstOf(theirs["pattern"]["panels"]);
    for (const char* key : {"pattern", "parameters", "parameter_order", "properties"}) {
        EXPECT_TRUE(ours.contains(key) && theirs.contains(key)) << key;
    }
    theirs["pattern"]["panel_order"] = nlohmann::json::array({"panel"});
    expectAlike(ours, theirs, "");
    expectAlike(theirs, ours, "");
}

TEST(DividedChain, KeepsTheCurveAndItsLength) {
    const CubicCurve curve{{0, 0}, {30, 50}, {70, -40}, {100, 10}};
    const std::vector<CubicCurve> chain{curve, straightCurve({100, 10}, {150, 10})};
    const double length = curveLength(curve);
    const auto parts =
        dividedChain(chain, {0.25 * length, 0.5 * length, length, length + 20}, 1e-9);
    ASSERT_EQ(parts.size(), 5U);
    EXPECT_NEAR(curveLength(parts), curveLength(chain), 1e-7);
    EXPECT_NEAR(curveLength(parts[0]), 0.25 * length, 1e-7);
    EXPECT_NEAR(curveLength(parts[1]), 0.25 * length, 1e-7);
    EXPECT_NEAR(curveLength(parts[3]), 20, 1e-9);
    for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
        EXPECT_EQ(parts[k].end, parts[k + 1].start);
    }
    const Points2 samples = sampled({curve}, 200), ofParts = sampled({parts[0]}, 20);
    for (const auto& point : ofParts.rowwise()) {
        EXPECT_LT((samples.rowwise() - point).rowwise().norm().minCoeff(), 1);
    }
}

}  // namespace
}  // namespace toile
