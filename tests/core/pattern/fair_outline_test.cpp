// SPDX-License-Identifier: GPL-3.0-or-later
// Fair lines of outlines that nearly touch themselves.
#include "core/pattern/fair_outline.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "core/pattern/segments.h"
#include "core/quality/outline_crossings.h"

namespace toile {
namespace {

using CornerList = std::vector<Eigen::RowVector2d>;

bool isSimpleLine(const Points2& points) {
    std::vector<int> loop(static_cast<std::size_t>(points.rows()));
    std::iota(loop.begin(), loop.end(), 0);
    return outlineIsSimple(points, loop);
}

/// A polygon with edges of about this length, its points off by up to `noise`.
Points2 uneven(const CornerList& corners, double edge, double noise, unsigned seed) {
    std::mt19937 random(seed);
    const auto off = [&] { return noise * (2.0 * random() / std::mt19937::max() - 1); };
    CornerList points;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Eigen::RowVector2d from = corners[k], to = corners[(k + 1) % corners.size()];
        const int count = std::max(1, static_cast<int>(std::round((to - from).norm() / edge)));
        for (int i = 0; i < count; ++i) {
            const Eigen::RowVector2d at = from + (to - from) * i / count;
            points.emplace_back(at.x() + off(), at.y() + off());
        }
    }
    Points2 line(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t k = 0; k < points.size(); ++k) {
        line.row(static_cast<Eigen::Index>(k)) = points[k];
    }
    return line;
}

/// An outline that is the same in 3D, from corner to corner, and how it is to be drawn.
OutlineReference referenceTo(const Points2& points) {
    const auto line = geometry::Line::closed(points);
    OutlineReference reference{points, line.arc().values(), {}};
    for (int k = 0; k < line.count(); ++k) {
        reference.turn.push_back(line.turnAt(k));
    }
    return reference;
}

OutlinePlan planFor(const OutlineReference& reference) {
    const auto line = geometry::Line::closed(reference.points);
    OutlinePlan plan;
    plan.smoothing = 40;
    for (const int k : findCorners(reference.points, kPlainCorner)) {
        const double at = line.arc()[static_cast<std::size_t>(k)];
        if (!plan.corners.empty()) {
            plan.stretches.push_back({plan.corners.back().at, at, 1});
        }
        plan.corners.push_back({at, line.turnAt(k)});
    }
    if (plan.corners.empty()) {
        plan.stretches.push_back({0, line.length(), 1});
    } else {
        plan.stretches.push_back(
            {plan.corners.back().at, plan.corners.front().at + line.length(), 1});
    }
    return plan;
}

struct DrawnCount {
    int lines = 0, yielded = 0, refused = 0;
};

/// Draws an outline in many sizes and with many unevennesses; every line is simple.
DrawnCount drawnSimply(const CornerList& corners, double noise, double edge = 4) {
    DrawnCount drawn;
    for (const double size : {1.0, 0.3, 0.1}) {
        for (unsigned seed = 0; seed < 6; ++seed) {
            Points2 points = size * uneven(corners, edge, noise, seed);
            if (!isSimpleLine(points)) {
                ADD_FAILURE() << "the shape itself crosses, seed " << seed;
                continue;
            }
            const OutlineReference reference = referenceTo(points);
            const auto line = fairOutline(reference, planFor(reference), Progress());
            ++drawn.lines;
            if (!line) {
                EXPECT_EQ(line.error().code, ErrorCode::LineNotDrawn);
                ++drawn.refused;
                continue;
            }
            drawn.yielded += line->hasYielded ? 1 : 0;
            EXPECT_TRUE(isSimpleLine(line->points)) << size << ' ' << seed;
            const auto closed = geometry::Line::closed(line->points, line->arc);
            for (Eigen::Index k = 0; k < points.rows(); ++k) {
                points.row(k) = closed.pointAt(reference.arc[static_cast<std::size_t>(k)]);
            }
            EXPECT_TRUE(isSimpleLine(points)) << size << ' ' << seed;
        }
    }
    return drawn;
}

TEST(FairOutlines, OfAStripDoNotCross) {
    const DrawnCount drawn = drawnSimply({{0, 0}, {300, 0}, {300, 3}, {0, 3}}, 1.2);
    EXPECT_LE(drawn.refused, drawn.lines / 2);
}

TEST(FairOutlines, OfAConcaveOutlineThatNearlyTouchesDoNotCross) {
    // Two jaws, open by half a millimetre between their tips.
    const DrawnCount jaws = drawnSimply(
        {{0, 0}, {80, 0}, {80, 39.7}, {30, 25}, {30, 55}, {80, 40.3}, {80, 80}, {0, 80}}, 0.2);
    // A bay whose neck is narrower than a step of the line.
    const DrawnCount bay = drawnSimply({{0, 0},
                                        {60, 0},
                                        {60, 60},
                                        {31, 60},
                                        {31, 50},
                                        {38, 44},
                                        {30, 36},
                                        {22, 44},
                                        {30, 50},
                                        {30, 60},
                                        {0, 60}},
                                       0.3);
    EXPECT_GT(jaws.yielded + bay.yielded, 0);  // so that there is something to see
    EXPECT_LE(jaws.refused + bay.refused, (jaws.lines + bay.lines) / 2);
}

TEST(FairOutlines, OfASlitDoNotCross) {
    const CornerList slit{{0, 0},      {60, 0},     {60, 60},    {30.15, 60},
                          {30.14, 20}, {29.86, 20}, {29.85, 60}, {0, 60}};
    for (const double edge : {0.7, 1.5, 3.0}) {
        const DrawnCount drawn = drawnSimply(slit, 0.1, edge);
        EXPECT_GT(drawn.yielded, 0) << edge;
        EXPECT_EQ(drawn.refused, 0) << edge;
    }
}

}  // namespace
}  // namespace toile
