// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces drawn as mirror images, through the whole pipeline.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/export/writers.h"
#include "core/flatten/base/outline_targets.h"
#include "core/pattern/drawn_outline.h"
#include "core/pattern/target_lengths.h"
#include "core/pipeline/garment_flattener.h"
#include "core/pipeline/pipeline.h"
#include "core/seam/seam_measure.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/symmetry/mirror_shapes.h"

namespace toile {
namespace {

constexpr double kMirrorImage = 1e-9, kSameSeam = 1e-6;  // mm

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

Points2 imageOf(const Points2& points) {
    Points2 image = points.colwise().reverse();
    image.col(0) *= -1;
    return image;
}

Points2 rolled(const Points2& points, Eigen::Index by) {
    Points2 rolled(points.rows(), 2);
    rolled << points.bottomRows(points.rows() - by), points.topRows(by);
    return rolled;
}

/// The shift at which the points of two closed lines lie alike about their means.
Eigen::Index shiftOf(const Points2& points, const Points2& onto) {
    const auto radii = [](const Points2& of) -> Eigen::VectorXd {
        return (of.rowwise() - of.colwise().mean()).rowwise().norm();
    };
    const Eigen::VectorXd a = radii(points), b = radii(onto);
    const Eigen::Index n = a.size();
    Eigen::Index best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index by = 0; by < n; ++by) {
        const double off = (a.tail(n - by) - b.head(n - by)).squaredNorm() +
                           (a.head(by) - b.tail(by)).squaredNorm();
        if (off < least) {
            best = by;
            least = off;
        }
    }
    return best;
}

/// How far a line's mirror image lies from another, once it is laid over it, mm.
double apart(const FlatLine& line, const FlatLine& other) {
    if (line.points.rows() != other.points.rows()) {
        return std::numeric_limits<double>::infinity();
    }
    const Points2 image = imageOf(line.points);
    const Points2 shifted = rolled(image, shiftOf(image, other.points));
    return (laidOver(shifted, other.points) - other.points).rowwise().norm().maxCoeff();
}

struct Case {
    const char* garment;
    std::size_t mirrored;  ///< pieces that are drawn as mirror images
};

class MirroredLines : public testing::TestWithParam<Case> {};

std::vector<bool> isMirrored(const Garment& garment, const PieceResults& results) {
    std::vector<bool> is(garment.pieces.size());
    for (std::size_t p = 0; p < is.size(); ++p) {
        is[p] = results[p]->plan && results[p]->plan->mirrored;
    }
    return is;
}

void expectMirrorImages(const Garment& garment, const Symmetry& symmetry,
                        const PieceResults& results) {
    const std::vector<bool> is = isMirrored(garment, results);
    for (std::size_t p = 0; p < is.size(); ++p) {
        if (is[p]) {
            const auto other = static_cast<std::size_t>(symmetry.pieces.counterpart[p]);
            ASSERT_TRUE(results[p]->flat->line) << garment.pieces[p]->name;
            EXPECT_LT(apart(*results[p]->flat->line, *results[other]->flat->line), kMirrorImage)
                << garment.pieces[p]->name;
        }
    }
}

void expectLengths(const Garment& garment, const PieceResults& results) {
    for (const auto& result : results) {
        ASSERT_TRUE(result->flat) << result->piece->name;
        EXPECT_LE(result->quality->maxBoundaryLengthError, 1e-9) << result->piece->name;
        EXPECT_EQ(result->quality->flippedTriangles, 0) << result->piece->name;
        for (const Error& note : result->flat->notes) {
            EXPECT_NE(note.code, ErrorCode::LineNotDrawn) << result->piece->name;
        }
    }
    for (const Seam& seam : garment.seams.seams) {
        if (seam.kind == SeamKind::Free || seam.left.loop != 0 || seam.right.loop != 0) {
            continue;
        }
        const PieceResult& left = *results[seam.left.piece];
        const PieceResult& right = *results[seam.right.piece];
        const SeamMeasure measure =
            measureSeam(seam, *left.piece, *left.flat, *right.piece, *right.flat);
        const double ratio = seam.length3d[1] / seam.length3d[0];
        EXPECT_NEAR(measure.length2dRight, ratio * measure.length2dLeft, kSameSeam) << seam.name;
    }
}

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
            const std::vector<bool> is = isMirrored(garment, results);
            EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(is, true)), GetParam().mirrored);
            expectMirrorImages(garment, *symmetry, results);
            expectLengths(garment, results);
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
    const auto report = nlohmann::json::parse(writeReport(garment, results, {}, &*symmetry));
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

}  // namespace
}  // namespace toile
