// SPDX-License-Identifier: GPL-3.0-or-later
// Segments of pattern pieces, and their curves.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/pattern/curve_fit.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/symmetry/mirror_shapes.h"

namespace toile {
namespace {

using Eigen::Vector2d;

struct DrawnPattern {
    Garment garment;
    Pattern pattern;
};

DrawnPattern drawnPattern(const std::string& name, const LineSettings& lines) {
    DrawnPattern made{name == "tube" ? test::tube4(test::draped) : test::garmentOf(name), {}};
    Progress progress;
    made.pattern =
        makePattern(made.garment, flattenGarment(made.garment, {}, progress, 0, lines), lines);
    return made;
}

LineSettings fairLines(Mirror mirror = Mirror::None) {
    LineSettings lines;
    lines.fairing = Fairing{};
    lines.trueBelow = kProposedTrueing;
    lines.mirror = mirror;
    return lines;
}

double distanceTo(const Points2& line, const Vector2d& point) {
    double nearest = 1e300;
    for (Eigen::Index k = 0; k + 1 < line.rows(); ++k) {
        const Vector2d a = line.row(k), b = line.row(k + 1);
        nearest =
            std::min(nearest, (a + geometry::nearestShare(point, a, b) * (b - a) - point).norm());
    }
    return nearest;
}

class PatternSegments : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        if (std::string(GetParam()) != "tube") {
            TOILE_NEEDS_SHARED(test::dataFile(GetParam()));
        }
    }
};

TEST_P(PatternSegments, CoverTheOutlineInOrder) {
    for (const LineSettings& lines : {LineSettings{}, fairLines(), fairLines(Mirror::Mean)}) {
        const DrawnPattern made = drawnPattern(GetParam(), lines);
        for (const PatternPiece& piece : made.pattern.pieces) {
            ASSERT_FALSE(piece.segments.empty()) << piece.name;
            for (std::size_t k = 0; k < piece.segments.size(); ++k) {
                const PatternSegment& segment = piece.segments[k];
                const bool isLast = k + 1 == piece.segments.size();
                const double next =
                    isLast ? piece.segments[0].from + geometry::Line::closed(piece.outline).length()
                           : piece.segments[k + 1].from;
                EXPECT_NEAR(segment.to, next, 1e-6) << piece.name;
                EXPECT_NEAR(segment.to - segment.from, segment.length, 1e-6) << piece.name;
                EXPECT_EQ(segment.seam == 0, !segment.place.line) << piece.name;
            }
        }
    }
}

TEST_P(PatternSegments, CurvesAreAsLongAsToldAndOnTheLine) {
    const DrawnPattern made = drawnPattern(GetParam(), fairLines(Mirror::Mean));
    for (const PatternPiece& piece : made.pattern.pieces) {
        const auto outline = geometry::Line::closed(piece.outline);
        for (const PatternSegment& segment : piece.segments) {
            const auto curves = curvesOf(piece, outline, segment);
            ASSERT_FALSE(curves.empty());
            EXPECT_NEAR(curveLength(curves), segment.length, kCurveLengthTolerance) << piece.name;
            const Points2 line = outline.part(segment.from, segment.to);
            EXPECT_LT((curves.front().start.transpose() - line.row(0)).norm(), 1e-12);
            EXPECT_LT((curves.back().end.transpose() - line.bottomRows<1>()).norm(), 1e-12);
            const Points2 samples = sampled(curves, 16);
            double farthest = 0;
            for (Eigen::Index k = 0; k < samples.rows(); ++k) {
                farthest = std::max(farthest, distanceTo(line, samples.row(k)));
            }
            EXPECT_LT(farthest, kCurveTolerance) << piece.name;
        }
    }
}

TEST_P(PatternSegments, BothSidesOfASeamHaveCurvesOfOneLength) {
    const DrawnPattern made = drawnPattern(GetParam(), fairLines());
    std::map<std::pair<int, bool>, double> lengths;
    for (const PatternPiece& piece : made.pattern.pieces) {
        const auto outline = geometry::Line::closed(piece.outline);
        for (const PatternSegment& segment : piece.segments) {
            lengths[{segment.seam, segment.isRight}] +=
                curveLength(curvesOf(piece, outline, segment));
        }
    }
    int compared = 0;
    for (std::size_t s = 0; s < made.garment.seams.seams.size(); ++s) {
        const Seam& seam = made.garment.seams.seams[s];
        const int number = static_cast<int>(s) + 1;
        const bool isWhole = lengths.contains({number, false}) && lengths.contains({number, true});
        if (seam.kind != SeamKind::Free && isWhole && !seam.stacked) {
            ++compared;
            const double ratio = seam.length3d[0] / seam.length3d[1];
            const double left = lengths[{number, false}], right = lengths[{number, true}];
            EXPECT_NEAR(left, ratio * right, 0.02) << seam.name;
        }
    }
    EXPECT_GT(compared, 3);
}

TEST_P(PatternSegments, PolygonsStayPolygons) {
    const DrawnPattern made = drawnPattern(GetParam(), {});
    for (const PatternPiece& piece : made.pattern.pieces) {
        EXPECT_FALSE(piece.isFine);
        const auto outline = geometry::Line::closed(piece.outline);
        for (const PatternSegment& segment : piece.segments) {
            for (const CubicCurve& curve : curvesOf(piece, outline, segment)) {
                EXPECT_TRUE(curve.isLine) << piece.name;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Garments, PatternSegments,
                         testing::Values("tube", "garments/tee_sim.obj", "garments/dress.obj"));

TEST(PatternSegmentsByHand, ATurnPointThatWasAddedPartsASegment) {
    const Garment garment = test::garmentOf("samples/tshirt.obj");
    Progress progress;
    const PieceResults results = flattenGarment(garment, {}, progress);
    const PatternPiece before = makePattern(garment, results).pieces[0];
    const PatternSegment& longest = *std::ranges::max_element(
        before.segments, {}, [](const PatternSegment& s) { return s.length; });
    LineSettings lines;
    lines.turnPoints.push_back({longest.place.line, (longest.place.from + longest.place.to) / 2,
                                longest.place.from > longest.place.to});
    const PatternPiece after = makePattern(garment, results, lines).pieces[0];
    ASSERT_EQ(after.segments.size(), before.segments.size() + 1);
    const auto outline = geometry::Line::closed(before.outline);
    const double middle = (longest.from + longest.to) / 2;
    EXPECT_TRUE(std::ranges::any_of(after.segments, [&](const PatternSegment& segment) {
        return segment.isCorner && outline.apart(segment.from, middle) < 1e-4;
    }));
}

}  // namespace
}  // namespace toile
