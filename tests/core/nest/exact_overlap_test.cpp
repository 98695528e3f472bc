// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>
#include <polyclipping/clipper.hpp>

#include "core/nest/collision.h"
#include "tests/core/nest/nest_shapes.h"

namespace {

using namespace toile;
using geometry::Polygon;
using nest::doOverlap;
using test::nestPolygon;
using test::nestRectangle;

Polygon moved(Polygon polygon, double x, double y) {
    polygon.col(0).array() += x;
    polygon.col(1).array() += y;
    return polygon;
}

TEST(ExactOverlap, SquaresThatTouchDoNotOverlap) {
    const Polygon square = nestRectangle(10, 10);
    for (const auto& [x, y] : {std::pair{10., 0.}, {10., 5.}, {10., 10.}, {0., -10.}, {25., 0.}}) {
        EXPECT_FALSE(doOverlap({square}, {moved(square, x, y)})) << x << ", " << y;
    }
    const double justInside = std::nextafter(10.0, 0.0);
    for (const auto& [x, y] :
         {std::pair{0., 0.}, {5., 0.}, {0., 5.}, {justInside, 0.}, {-justInside, 9.}}) {
        EXPECT_TRUE(doOverlap({square}, {moved(square, x, y)})) << x << ", " << y;
    }
}

TEST(ExactOverlap, CornersThatMeetCornersTellByTheirWedges) {
    const Polygon square = nestRectangle(10, 10);
    const Polygon half = nestPolygon({{0, 0}, {10, 10}, {0, 10}});   // on the square's diagonal
    const Polygon other = nestPolygon({{0, 0}, {10, 0}, {10, 10}});  // the square's other half
    EXPECT_TRUE(doOverlap({square}, {half}));
    EXPECT_FALSE(doOverlap({half}, {other}));
    EXPECT_TRUE(doOverlap({nestRectangle(2, 2)}, {square}));
}

TEST(ExactOverlap, RingsThatTouchDoNotCross) {
    using nest::doRingsCross;
    const Polygon square = nestRectangle(10, 10);
    EXPECT_FALSE(doRingsCross({square}));
    EXPECT_FALSE(doRingsCross({square, moved(nestRectangle(4, 4), 0, 3)}));
    EXPECT_FALSE(doRingsCross({square, nestPolygon({{0, 0}, {5, 2}, {2, 5}})}));
    EXPECT_FALSE(doRingsCross(  // pinched at (5, 5), and a slit
        {nestPolygon({{0, 0}, {10, 0}, {5, 5}, {10, 10}, {0, 10}, {5, 5}})}));
    EXPECT_FALSE(doRingsCross(
        {nestPolygon({{0, 0}, {10, 0}, {10, 10}, {5, 10}, {5, 5}, {5, 10}, {0, 10}})}));
    EXPECT_TRUE(doRingsCross({nestPolygon({{0, 0}, {10, 10}, {10, 0}, {0, 10}})}));
    EXPECT_TRUE(doRingsCross(  // through the point (5, 5), once of both ways
        {nestPolygon({{0, 0}, {5, 5}, {10, 10}, {10, 0}, {5, 5}, {0, 10}})}));
    EXPECT_TRUE(doRingsCross({nestPolygon({{0, 0}, {5, 5}, {10, 10}, {10, 0}, {0, 10}})}));
    EXPECT_TRUE(doRingsCross({square, moved(square, 5, 3)}));
}

TEST(ExactOverlap, WhatLiesInAHoleDoesNotOverlap) {
    const Polygon hole = moved(nestRectangle(6, 6), 2, 2);
    const nest::Rings frame = nest::wound({nestRectangle(10, 10), hole});
    EXPECT_FALSE(doOverlap(frame, {moved(nestRectangle(4, 4), 3, 3)}));
    EXPECT_FALSE(doOverlap({hole}, frame));
    EXPECT_TRUE(doOverlap(frame, {moved(nestRectangle(6, 6), 2.5, 2)}));
    EXPECT_TRUE(doOverlap(frame, {moved(nestRectangle(8, 8), 1, 1)}));
    EXPECT_TRUE(doOverlap(frame, {moved(nestRectangle(12, 12), -1, -1)}));
}

/// Stars of whole numbers on a small grid, so that corners and edges meet often, against the area
/// that Clipper finds common to both.
TEST(ExactOverlap, AgreesWithClipperOnWholeNumbers) {
    nest::Random random(7);
    const auto star = [&random] {
        Polygon polygon = test::nestStar(random, 3 + static_cast<int>(random.below(6)), 2.2, 6);
        polygon = polygon.array().round();
        const auto x = static_cast<double>(random.below(9));
        const auto y = static_cast<double>(random.below(9));
        return moved(polygon, x, y);
    };
    const auto pathOf = [](const Polygon& polygon) {
        ClipperLib::Path path;
        for (Eigen::Index k = 0; k < polygon.rows(); ++k) {
            path.emplace_back(std::llround(polygon(k, 0) * 1e6), std::llround(polygon(k, 1) * 1e6));
        }
        return path;
    };
    int overlapping = 0, compared = 0;
    for (int k = 0; k < 3000; ++k) {
        const Polygon a = star(), b = star();
        ClipperLib::Clipper clipper;
        if (!clipper.AddPath(pathOf(a), ClipperLib::ptSubject, true) ||
            !clipper.AddPath(pathOf(b), ClipperLib::ptClip, true)) {
            continue;
        }
        ClipperLib::Paths common;
        clipper.Execute(ClipperLib::ctIntersection, common, ClipperLib::pftNonZero,
                        ClipperLib::pftNonZero);
        double area = 0;
        for (const auto& path : common) {
            area += ClipperLib::Area(path) * 1e-12;
        }
        ++compared;
        overlapping += area > 1e-4 ? 1 : 0;
        EXPECT_EQ(doOverlap({a}, {b}), area > 1e-4) << k << ": " << area << '\n'
                                                    << a << "\n\n"
                                                    << b;
        EXPECT_EQ(doOverlap({b}, {a}), area > 1e-4) << k;
    }
    EXPECT_GT(compared, 2500);
    EXPECT_GT(overlapping, 500);
    EXPECT_LT(overlapping, compared - 200);
}

}  // namespace
