// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the predicted effect of cuts comes true when the cloth is flattened, and what tailors'
// cuts cost and save next to the shortest; the tables in docs/tailor.md.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <map>
#include <numeric>
#include <utility>

#include <gtest/gtest.h>

#include "core/base/text.h"
#include "core/toile/pipeline.h"
#include "tests/cli/docs_table.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

/// Our samples have their panels apart: sewn where their rims lie on each other, they are one skin.
std::filesystem::path sewnSample(const std::string& name) {
    Progress progress;
    const auto garment =
        loadGarment({test::dataFile("samples/" + name)}, {.split = SplitMode::Objects}, progress);
    std::map<std::array<long long, 3>, int> places;
    std::vector<Eigen::Vector3d> vertices;
    std::string faces;
    for (const auto& piece : garment->uncut) {
        std::vector<int> at;
        for (Eigen::Index v = 0; v < piece->mesh.V.rows(); ++v) {
            const Eigen::Vector3d p = piece->mesh.V.row(v);
            const std::array<long long, 3> key{std::llround(1e4 * p.x()), std::llround(1e4 * p.y()),
                                               std::llround(1e4 * p.z())};
            const auto [place, isNew] = places.emplace(key, static_cast<int>(vertices.size()) + 1);
            if (isNew) {
                vertices.push_back(p);
            }
            at.push_back(place->second);
        }
        for (Eigen::Index f = 0; f < piece->mesh.F.rows(); ++f) {
            faces += "f";
            for (int k = 0; k < 3; ++k) {
                faces += " " + std::to_string(at[piece->mesh.F(f, k)]);
            }
            faces += "\n";
        }
    }
    const std::filesystem::path path =
        std::filesystem::path(testing::TempDir()) / ("skin_of_" + name);
    std::ofstream file(path);
    file << std::setprecision(17);
    for (const Eigen::Vector3d& p : vertices) {
        file << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    }
    file << faces;
    return path;
}

Garment skinOf(const std::string& file, bool isAutoCut = false, CutStyle style = CutStyle::Topology,
               std::optional<double> enough = {}) {
    Progress progress;
    const bool isSample = file.starts_with("samples/");
    auto garment = loadGarment(
        {isSample ? sewnSample(file.substr(8)) : test::dataFile(file)},
        {.unit = isSample ? std::optional(FileUnit(LengthUnit::Millimetre)) : std::nullopt,
         .split = SplitMode::Components,
         .weld = true,
         .autoCut = isAutoCut,
         .cutStyle = style,
         .enoughStrain = enough},
        progress);
    EXPECT_TRUE(garment) << file;
    return garment ? *garment : Garment{};
}

std::vector<double> ranksOf(const std::vector<double>& values) {
    std::vector<double> ranks;
    for (const double value : values) {
        double rank = 0;
        for (const double other : values) {
            rank += other < value ? 1 : other == value ? 0.5 : 0;
        }
        ranks.push_back(rank);
    }
    return ranks;
}

/// Spearman's.
double rankCorrelation(const std::vector<double>& a, const std::vector<double>& b) {
    const std::vector<double> x = ranksOf(a), y = ranksOf(b);
    const double middle = static_cast<double>(a.size()) / 2;
    double xx = 0, yy = 0, xy = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        xx += (x[k] - middle) * (x[k] - middle);
        yy += (y[k] - middle) * (y[k] - middle);
        xy += (x[k] - middle) * (y[k] - middle);
    }
    return xy / std::sqrt(xx * yy);
}

std::string percentOf(double part) {
    return fixed(100 * part, 1);
}

TEST(CutAdviceTruthSlow, ForetoldStrainRanksCutsAsFlatteningDoes) {
    constexpr std::pair<const char*, std::size_t> kFiles[] = {
        {"garments/dress.obj", 3}, {"garments/leggings.ply", 5}, {"disks/mannequin-devil.off", 5}};
    TOILE_NEEDS_SHARED(test::sharedFile("garments"));
    std::string table =
        "| File | Cut, after those before it | In all mm | Mean strain predicted % | solved % | "
        "Most predicted % | solved % |\n|---|---|--:|--:|--:|--:|--:|\n";
    std::vector<double> predictedMeans, solved, mostPredicted, mostSolved;
    for (const auto& [file, count] : kFiles) {
        const Garment skin = skinOf(file);
        ASSERT_EQ(skin.uncut.size(), 1U);
        const CutAdvice advice = adviseCuts(skin.uncut[0], {}, {});
        double inAll = 0;
        for (std::size_t k = 0; k <= std::min(count, advice.cuts.size()); ++k) {
            Progress progress;
            const auto flat =
                solvedStrain(skin.uncut[0], {}, advice, k, {.quality = Quality::Draft}, progress);
            ASSERT_TRUE(flat) << file << k;
            const StrainFigures& predicted = k == 0 ? advice.before : advice.cuts[k - 1].predicted;
            inAll += k == 0 ? 0 : advice.cuts[k - 1].length;
            predictedMeans.push_back(predicted.mean);
            solved.push_back(flat->mean);
            mostPredicted.push_back(predicted.most);
            mostSolved.push_back(flat->most);
            table += "| " + std::filesystem::path(file).filename().string() + " | " +
                     (k == 0 ? "the shortest" : advice.cuts[k - 1].what.cut.name) + " | " +
                     fixed(inAll, 0) + " | " + percentOf(predicted.mean) + " | " +
                     percentOf(flat->mean) + " | " + percentOf(predicted.most) + " | " +
                     percentOf(flat->most) + " |\n";
        }
    }
    EXPECT_GT(rankCorrelation(predictedMeans, solved), 0.9);
    EXPECT_GT(rankCorrelation(mostPredicted, mostSolved), 0.9);
    test::updateTableInDocs("tailor.md", "strain predicted and solved", table);
}

struct Outcome {
    std::size_t pieces = 0;
    double length = 0, mean = 0;
    bool areDisks = true, areSound = true;
    std::map<std::string, double> areas;  ///< by name
};

Outcome flatOf(const Garment& garment) {
    Outcome made;
    made.pieces = garment.pieces.size();
    for (const AppliedCut& cut : garment.cuts) {
        made.length += cut.length;
    }
    Progress progress;
    double area = 0;
    for (const auto& result : flattenGarment(garment, {.quality = Quality::Draft}, progress)) {
        made.areDisks = made.areDisks && !result->piece->defect;
        if (result->quality) {
            area += result->quality->area3d;
            made.areas[result->piece->name] = result->quality->area3d;
            made.mean += result->quality->area3d * result->quality->strainMeanAbs.value_or(0);
            made.areSound = made.areSound && result->quality->flippedTriangles == 0 &&
                            result->quality->outlineCrossings == 0;
        }
    }
    made.mean /= area > 0 ? area : 1;
    return made;
}

TEST(CutAdviceTruthSlow, TailorsCutsStrainLessAndAreLittleLonger) {
    struct Skin {
        const char* file;
        double mostStrain;             ///< of that of the shortest cuts
        std::optional<double> enough;  ///< where the mesh shows seams that strain does not ask for
    };
    constexpr Skin kSkins[] = {{"garments/leggings.ply", 1, {}},
                               {"garments/suit_mh.obj", 0.5, {}},
                               {"samples/trousers.obj", 1, 0.03},
                               {"samples/tshirt.obj", 1, 0.03}};
    std::string table =
        "| File | Pieces | Cuts m | Mean strain % | The shortest: pieces | m | % |\n"
        "|---|--:|--:|--:|--:|--:|--:|\n";
    for (const auto& [file, most, enough] : kSkins) {
        if (!std::filesystem::exists(test::dataFile(file))) {
            continue;
        }
        SCOPED_TRACE(file);
        const Outcome tailor = flatOf(skinOf(file, true, CutStyle::Tailor, enough));
        const Outcome shortest = flatOf(skinOf(file, true));
        EXPECT_TRUE(tailor.areDisks);
        EXPECT_TRUE(tailor.areSound);
        EXPECT_LE(tailor.mean, most * shortest.mean);
        EXPECT_LE(tailor.length, 1.5 * shortest.length);
        const bool isSymmetric = std::string(file).starts_with("samples/");
        for (const auto& [name, area] : tailor.areas) {
            if (const auto left = name.find("left "); left != std::string::npos) {
                const auto other = tailor.areas.find(std::string(name).replace(left, 4, "right"));
                ASSERT_NE(other, tailor.areas.end()) << name;
                EXPECT_NEAR(area, other->second, (isSymmetric ? 1e-6 : 0.1) * area) << name;
            }
        }
        table += "| " + std::filesystem::path(file).filename().string() +
                 (enough ? ", `--max-strain 3`" : "") + " | " + std::to_string(tailor.pieces) +
                 " | " + fixed(tailor.length / 1000, 2) + " | " + percentOf(tailor.mean) + " | " +
                 std::to_string(shortest.pieces) + " | " + fixed(shortest.length / 1000, 2) +
                 " | " + percentOf(shortest.mean) + " |\n";
    }
    test::updateTableInDocs("tailor.md", "tailors' cuts and the shortest", table);
}

}  // namespace
}  // namespace toile
