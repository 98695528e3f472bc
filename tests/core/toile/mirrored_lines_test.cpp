// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces drawn as mirror images, through the whole pipeline.
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/flatten/base/outline_targets.h"
#include "core/formats/writers.h"
#include "core/pattern/drawn_outline.h"
#include "core/pattern/target_lengths.h"
#include "core/seam/seam_measure.h"
#include "core/toile/garment_flattener.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/symmetry/mirror_shapes.h"
#include "tests/core/toile/mirror_images.h"

namespace toile {
namespace {

/// A pattern that knows no more than that.
Pattern patternIn(const Symmetry& symmetry) {
    Pattern pattern;
    pattern.symmetry = std::make_shared<const Symmetry>(symmetry);
    return pattern;
}

Garment garmentNamed(const std::string& name) {
    return name == "tube" ? test::tube4(test::draped) : test::garmentOf(name);
}

LineSettings mirrored(bool isFair, Mirror mirror = Mirror::Mean) {
    LineSettings lines;
    lines.mirror = mirror;
    if (isFair) {
        lines.fairing = Fairing{};
        lines.trueBelow = kProposedTrueing;
    }
    return lines;
}

PieceResults flattenedAs(const Garment& garment, const LineSettings& lines, int threads = 0) {
    Progress progress;
    return flattenGarment(garment, {}, progress, threads, lines);
}

struct Case {
    const char* garment;
    std::size_t mirrored;  ///< pieces that are drawn as mirror images
};

class MirroredLines : public testing::TestWithParam<Case> {};

void expectSameLines(const PieceResults& a, const PieceResults& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t p = 0; p < a.size(); ++p) {
        EXPECT_EQ(a[p]->flat->Q, b[p]->flat->Q);
        ASSERT_EQ(!a[p]->flat->line, !b[p]->flat->line);
        if (a[p]->flat->line) {
            EXPECT_EQ(a[p]->flat->line->points, b[p]->flat->line->points);
            EXPECT_EQ(a[p]->flat->line->arc, b[p]->flat->line->arc);
        }
    }
}

TEST_P(MirroredLines, AreMirrorImagesAndSeamsStayEqual) {
    if (std::string(GetParam().garment) != "tube") {
        TOILE_NEEDS_SHARED(test::dataFile(GetParam().garment));
    }
    const Garment garment = garmentNamed(GetParam().garment);
    const auto symmetry = findSymmetry(garment);
    ASSERT_TRUE(symmetry);
    for (const bool isFair : {false, true}) {
        for (const Mirror mirror : {Mirror::Mean, Mirror::First}) {
            const PieceResults results = flattenedAs(garment, mirrored(isFair, mirror));
            const std::vector<bool> is = test::areMirrored(results);
            EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(is, true)), GetParam().mirrored);
            test::expectMirrorImages(garment, *symmetry, results);
            test::expectLengths(garment, results);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Garments, MirroredLines,
                         testing::Values(Case{"tube", 4}, Case{"samples/tshirt.obj", 5},
                                         Case{"samples/bodice.obj", 7},
                                         Case{"garments/tee_sim.obj", 6},
                                         Case{"garments/dress.obj", 7},
                                         Case{"garments/polo.obj", 3}));

TEST(MirroredLinesOfATube, SameWhateverTheThreads) {
    const Garment garment = test::tube4(test::draped);
    expectSameLines(flattenedAs(garment, mirrored(true), 1),
                    flattenedAs(garment, mirrored(true), 2));
}

TEST(MirroredLinesOfATube, NoneIsAsBefore) {
    const Garment garment = test::tube4(test::draped);
    for (const auto& result : flattenedAs(garment, {})) {
        EXPECT_EQ(result->targets.lengths.size(), 0);
        EXPECT_FALSE(result->exact);
    }
}

TEST(MirroredLinesOfATube, AsInTheFileWhereASeamDiffersTooMuch) {
    // The left side hangs lower: its seams are some 15 mm longer than those on the right.
    const Garment garment = test::tube4([](const Eigen::Vector3d& p) -> Eigen::Vector3d {
        return p - Eigen::Vector3d(0, std::max(0.0, p.x()) / 200 * 16 * (1 - p.y() / 600), 0);
    });
    const LineSettings lines = mirrored(false, Mirror::Close);
    const auto symmetry = symmetryOf(garment, lines);
    ASSERT_TRUE(symmetry);
    ASSERT_FALSE(symmetry->unequal.empty());
    const PieceResults kept = flattenedAs(garment, lines);
    for (std::size_t p = 0; p < kept.size(); ++p) {
        if (symmetry->kept[p]) {
            EXPECT_LE(kept[p]->quality->maxBoundaryLengthError, 1e-9) << kept[p]->piece->name;
            EXPECT_FALSE(kept[p]->plan && kept[p]->plan->mirrored);
        }
    }
    double changed = 0;
    for (const auto& result : flattenedAs(garment, mirrored(false, Mirror::Mean))) {
        EXPECT_LE(result->quality->maxTargetLengthError, 1e-9) << result->piece->name;
        for (const LengthChange& change : changesOf(*result)) {
            EXPECT_EQ(change.cause, LengthCause::Mirroring);
            changed = std::max(changed, std::abs(change.millimetres));
        }
    }
    const UnequalPieces& worst = symmetry->unequal.front();
    EXPECT_NEAR(changed, worst.difference / 2, 0.5);
}

TEST(MirroredLinesOfATube, AreFoundAgainByPointer) {
    const Garment garment = test::tube4(test::draped);
    GarmentFlattener flattener;
    Progress progress;
    const LineSettings lines = mirrored(true);
    const PieceResults first = flattener.flatten(garment, {}, progress, 0, {}, lines);
    expectSameLines(first, flattenedAs(garment, lines));
    EXPECT_EQ(flattener.flatten(garment, {}, progress, 0, first, lines), first);
    const PieceResults none = flattener.flatten(garment, {}, progress, 0, first, {});
    const PieceResults settled = flattener.settle(garment, none, progress);
    expectSameLines(settled, flattenedAs(garment, {}));
}

TEST(MirroredLinesOfATube, CancelledWhileThePlaneIsLookedFor) {
    const Garment garment = test::tube4(test::draped);
    const LineSettings lines = mirrored(false);
    GarmentFlattener flattener;
    Progress cancelled;
    cancelled.cancel();
    EXPECT_FALSE(findSymmetry(garment, cancelled));
    EXPECT_FALSE(flattener.symmetryOf(garment, lines, cancelled));
    for (const PieceResults& results : {flattenGarment(garment, {}, cancelled, 0, lines),
                                        flattener.flatten(garment, {}, cancelled, 0, {}, lines)}) {
        for (const auto& result : results) {
            ASSERT_TRUE(result->error);
            EXPECT_EQ(result->error->code, ErrorCode::Cancelled);
        }
    }
    EXPECT_TRUE(flattener.symmetryOf(garment, lines));
}

TEST(MirroredLinesOfATube, ThePlaneIsThatOfTheGarmentAsDivided) {
    const Garment garment = test::tube4(test::draped);
    Garment other = garment;  // as if it had been cut: only the plane stays
    other.pieces.pop_back();
    other.seams = {};
    GarmentFlattener flattener;
    const auto before = flattener.symmetryOf(garment, mirrored(false));
    const auto after = flattener.symmetryOf(other, mirrored(false));
    ASSERT_TRUE(before && after);
    EXPECT_EQ(after->plane.normal, before->plane.normal);
    EXPECT_EQ(after->plane.offset, before->plane.offset);
    EXPECT_EQ(after->pieces.counterpart, (std::vector<int>{0, -1, 2}));
    EXPECT_EQ(flattener.symmetryOf(other, mirrored(false)), after);
    other.uncut = other.pieces;
    const auto divided = flattener.symmetryOf(other, mirrored(false));
    EXPECT_TRUE(!divided || divided->plane.offset != before->plane.offset);
}

TEST(MirroredLinesOfATube, HaveCommonLengths) {
    const Garment garment = test::tube4(test::draped);
    const auto symmetry = findSymmetry(garment);
    ASSERT_TRUE(symmetry);
    const auto targets = outlineTargets(garment, {}, &*symmetry);
    const auto perimeter = [&](std::size_t p) {
        return outlineLengths(*garment.pieces[p], targets[p]).sum();
    };
    EXPECT_NEAR(perimeter(1), perimeter(3), 1e-9);
    const auto exact = [&](std::size_t p) { return outlineLengths(*garment.pieces[p], {}).sum(); };
    EXPECT_GT(std::abs(exact(1) - exact(3)), 1e-3);
}

TEST(MirroredLinesOfATube, TheFirstStaysAsItIs) {
    const Garment garment = test::tube4(test::draped);
    const PieceResults results = flattenedAs(garment, mirrored(false, Mirror::First));
    const double first = results[1]->flat->line->farthest;  // on the side of +x
    const double second = results[3]->flat->line->farthest;
    EXPECT_LT(std::min(first, second), 1e-9);
    EXPECT_GT(std::max(first, second), 1e-3);
}

TEST(MirroredLinesReport, SaysWhatIsMirroredWhereThatWasAskedFor) {
    const Garment garment = test::garmentOf("samples/tshirt.obj");
    const auto symmetry = findSymmetry(garment);
    ASSERT_TRUE(symmetry);
    const PieceResults results = flattenedAs(garment, mirrored(false));
    EXPECT_FALSE(nlohmann::json::parse(writeReport(garment, results)).contains("symmetry"));
    const auto report = nlohmann::json::parse(writeReport(garment, results, patternIn(*symmetry)));
    const auto& said = report.at("symmetry");
    EXPECT_LT(said.at("deviation"), 1e-9);
    EXPECT_LT(said.at("largest_length_change"), 1e-9);
    EXPECT_TRUE(said.at("without_counterpart").empty());
    std::size_t pieces = 0;
    for (const auto& pair : said.at("pairs")) {
        EXPECT_TRUE(pair.at("equal"));
        pieces += pair.at("pieces").size();
    }
    EXPECT_EQ(pieces, garment.pieces.size());
}

/// The mean strain of all pieces by their areas, and the largest.
std::pair<double, double> strainOf(const PieceResults& results) {
    double sum = 0, area = 0, most = 0;
    for (const auto& result : results) {
        sum += result->quality->area3d * result->quality->strainMeanAbs.value_or(0);
        area += result->quality->area3d;
        most = std::max(most, result->quality->strainMax.value_or(0));
    }
    return {sum / area, most};
}

TEST(MirroredLinesReport, SaysWhatMirroringCostsInStrain) {
    Garment garment = test::tube4(test::draped);
    garment.files = {std::make_shared<const SourceFile>()};
    const auto symmetry = findSymmetry(garment);
    ASSERT_TRUE(symmetry);
    const PieceResults results = flattenedAs(garment, mirrored(false));
    const auto report = nlohmann::json::parse(writeReport(garment, results, patternIn(*symmetry)));
    const auto& said = report.at("symmetry");
    const auto [mean, most] = strainOf(results);
    const auto [exactMean, exactMost] = strainOf(exactResults(results));
    EXPECT_NEAR(said.at("strain_mean_abs"), mean, 1e-12);
    EXPECT_EQ(said.at("strain_max"), most);
    EXPECT_NEAR(said.at("exact").at("strain_mean_abs"), exactMean, 1e-12);
    EXPECT_EQ(said.at("exact").at("strain_max"), exactMost);
    EXPECT_NE(mean, exactMean);
    for (const auto& pair : said.at("pairs")) {
        EXPECT_LE(pair.at("strain_max"), most);
        EXPECT_LE(pair.at("exact").at("strain_max"), exactMost);
    }
}

}  // namespace
}  // namespace toile
