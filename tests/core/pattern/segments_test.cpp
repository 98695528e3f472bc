// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/segments.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/pattern/trueing.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

/// A closed line through corners, its sides divided into edges of about this length.
Points2 divided(const std::vector<Eigen::RowVector2d>& corners, double edge) {
    std::vector<Eigen::RowVector2d> points;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Eigen::RowVector2d from = corners[k], to = corners[(k + 1) % corners.size()];
        const int count = std::max(1, static_cast<int>(std::round((to - from).norm() / edge)));
        for (int i = 0; i < count; ++i) {
            points.emplace_back(from + (to - from) * i / count);
        }
    }
    Points2 line(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t k = 0; k < points.size(); ++k) {
        line.row(static_cast<Eigen::Index>(k)) = points[k];
    }
    return line;
}

std::vector<Eigen::RowVector2d> cornersOf(const Points2& line) {
    std::vector<Eigen::RowVector2d> found;
    for (const int k : findCorners(line)) {
        found.emplace_back(line.row(k));
    }
    return found;
}

TEST(FindCorners, FindsThoseOfARectangleHoweverItIsDivided) {
    const std::vector<Eigen::RowVector2d> corners{{0, 0}, {200, 0}, {200, 90}, {0, 90}};
    for (const double edge : {0.5, 2.0, 10.0, 90.0}) {
        EXPECT_EQ(cornersOf(divided(corners, edge)), corners) << edge;
    }
}

TEST(FindCorners, FindsBothCornersOfANarrowEnd) {
    const std::vector<Eigen::RowVector2d> strap{{0, 0}, {300, 0}, {300, 3}, {0, 3}};
    EXPECT_EQ(cornersOf(divided(strap, 3)), strap);
    const std::vector<Eigen::RowVector2d> step{{0, 0},   {100, 0}, {100, 50},
                                               {60, 50}, {60, 47}, {0, 47}};
    EXPECT_EQ(cornersOf(divided(step, 1)), step);
}

TEST(FindCorners, FindsNoneInACurveAndNoneInNoise) {
    std::vector<Eigen::RowVector2d> circle;
    for (int k = 0; k < 400; ++k) {
        const double angle = 2 * std::numbers::pi * k / 400;
        circle.emplace_back(60 * std::cos(angle), 60 * std::sin(angle));
    }
    EXPECT_TRUE(findCorners(divided(circle, 10)).empty());

    std::mt19937 random(7);
    std::normal_distribution<double> noise(0, 0.05);
    const std::vector<Eigen::RowVector2d> corners{{0, 0}, {200, 0}, {200, 90}, {0, 90}};
    Points2 rough = divided(corners, 0.5);
    for (double& coordinate : rough.reshaped()) {
        coordinate += noise(random);
    }
    const auto found = cornersOf(rough);
    ASSERT_EQ(found.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_LT((found[k] - corners[k]).norm(), 2) << k;
    }
}

TEST(FindCorners, TakesTheStrongestTurnOfARoundedCorner) {
    // 90 degrees in three turns within 3 mm: 20, 50, 20.
    std::vector<Eigen::RowVector2d> points{{0, 0}, {100, 0}};
    double direction = 0;
    for (const double turn : {20.0, 50.0, 20.0}) {
        direction += turn * std::numbers::pi / 180;
        points.emplace_back(points.back() +
                            1.5 * Eigen::RowVector2d(std::cos(direction), std::sin(direction)));
    }
    points.emplace_back(points.back().x(), 100);
    points.emplace_back(0, 100);
    Points2 line(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t k = 0; k < points.size(); ++k) {
        line.row(static_cast<Eigen::Index>(k)) = points[k];
    }
    EXPECT_EQ(findCorners(line), (std::vector<int>{0, 2, 5, 6}));
}

class Segments : public testing::TestWithParam<const char*> {
protected:
    void load() {
        Progress progress;
        garment_ = *loadGarment({test::dataFile(GetParam())}, {}, progress);
        results_ = flattenGarment(garment_, {Method::Curvature}, progress);
    }

    Garment garment_;
    PieceResults results_;
};

TEST_P(Segments, CoverEveryOutlineOnce) {
    TOILE_NEEDS_SHARED(test::dataFile(GetParam()));
    load();
    const auto all = findSegments(garment_, results_, {});
    for (std::size_t p = 0; p < all.size(); ++p) {
        const Piece& piece = *garment_.pieces[p];
        double perimeter = 0;
        for (std::size_t k = 0; k < piece.boundary.size(); ++k) {
            perimeter += (piece.mesh.V.row(piece.boundary[(k + 1) % piece.boundary.size()]) -
                          piece.mesh.V.row(piece.boundary[k]))
                             .norm();
        }
        ASSERT_EQ(all[p].segments.size(), std::max<std::size_t>(1, all[p].turnPoints.size()));
        double length = 0;
        for (std::size_t k = 0; k < all[p].segments.size(); ++k) {
            const Segment& segment = all[p].segments[k];
            EXPECT_GT(segment.length(), 0);
            EXPECT_TRUE(segment.place.line) << piece.name;
            length += segment.length();
            const Segment& next = all[p].segments[(k + 1) % all[p].segments.size()];
            EXPECT_NEAR(std::remainder(next.at.start - segment.at.end, perimeter), 0, 1e-9);
        }
        EXPECT_NEAR(length, perimeter, 1e-9 * perimeter);
    }
}

TEST_P(Segments, AreFoundAgainByTheirPlaces) {
    TOILE_NEEDS_SHARED(test::dataFile(GetParam()));
    load();
    LineSettings said;
    double number = 0;
    for (const OutlineSegments& of : findSegments(garment_, results_, {})) {
        for (const Segment& segment : of.segments) {
            said.segments.push_back({segment.place, ++number});
        }
    }
    number = 0;
    for (const OutlineSegments& of : findSegments(garment_, results_, said)) {
        for (const Segment& segment : of.segments) {
            EXPECT_EQ(segment.settings.length, ++number);
        }
    }
}

TEST_P(Segments, GetAndLoseTurnPointsByHand) {
    TOILE_NEEDS_SHARED(test::dataFile(GetParam()));
    load();
    const auto before = findSegments(garment_, results_, {});
    std::size_t longest = 0;
    for (std::size_t k = 0; k < before[0].segments.size(); ++k) {
        longest =
            before[0].segments[k].length() > before[0].segments[longest].length() ? k : longest;
    }
    const LineStretch place = before[0].segments[longest].place;
    LineSettings said;
    said.turnPoints.push_back(
        {place.line, (place.from + place.to) / 2, place.to < place.from, true});
    const auto added = findSegments(garment_, results_, said);
    ASSERT_EQ(added[0].segments.size(), before[0].segments.size() + 1);
    for (std::size_t p = 1; p < before.size(); ++p) {
        EXPECT_EQ(added[p].segments.size(), before[p].segments.size());
    }
    const Segment& whole = before[0].segments[longest];
    double perimeter = 0;
    for (const Segment& segment : before[0].segments) {
        perimeter += segment.length();
    }
    const double middle = whole.at.start + whole.length() / 2;
    EXPECT_TRUE(std::ranges::any_of(added[0].turnPoints, [&](const TurnPoint& point) {
        const double off = std::remainder(point.at - middle, perimeter);
        return point.byHand && std::abs(off) < 1e-6 * whole.length();
    }));

    said.turnPoints.front().turns = false;  // where there is none it does nothing
    EXPECT_EQ(findSegments(garment_, results_, said)[0].segments.size(), before[0].segments.size());
}

INSTANTIATE_TEST_SUITE_P(Garments, Segments,
                         testing::Values("samples/bodice.obj", "samples/trousers.obj",
                                         "samples/tshirt.obj", "garments/tee_sim.obj",
                                         "garments/dress.obj"));

TEST(SeamEnds, TruedTurnsTakeOutEveryKinkThatIsAskedFor) {
    Progress progress;
    const Garment garment = *loadGarment({test::dataFile("samples/bodice.obj")}, {}, progress);
    const PieceResults results = flattenGarment(garment, {Method::Curvature}, progress);
    LineSettings lines;
    lines.trueBelow = kMaxKink;
    const auto segments = findSegments(garment, results, lines);
    std::vector<SeamEnd> ends = findSeamEnds(garment, segments, lines);
    ASSERT_FALSE(ends.empty());
    const auto turns = truedTurns(segments, ends);
    for (const SeamEnd& end : ends) {
        EXPECT_NEAR(turns[end.left.piece][end.left.point] + turns[end.right.piece][end.right.point],
                    end.kink, 1e-12);
    }

    // One end that is said not to be trued keeps its kink; said that it is, without the others, it
    // alone loses it.
    const Seam& seam = garment.seams.seams[ends[0].seam];
    lines.seamEnds = {{seam.place, ends[0].atEnd, false}};
    EXPECT_FALSE(findSeamEnds(garment, segments, lines)[0].isTrued);
    lines.trueBelow = 0;
    lines.seamEnds[0].trued = true;
    ends = findSeamEnds(garment, segments, lines);
    EXPECT_EQ(std::ranges::count_if(ends, &SeamEnd::isTrued), 1);
    EXPECT_TRUE(ends[0].isTrued);
}

}  // namespace
}  // namespace toile
