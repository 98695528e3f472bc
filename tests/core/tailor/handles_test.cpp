// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/handles.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using Points = std::vector<Eigen::Vector3d>;

UserCut handled(UserCut::Kind kind, Points points) {
    return {"cut", kind, std::move(points)};
}

/// Straight from place to place of the plane z = 0.
Points straight(const Eigen::Vector2d& from, const Eigen::Vector2d& to, int steps) {
    Points points;
    for (int k = 0; k <= steps; ++k) {
        const Eigen::Vector2d at = from + (static_cast<double>(k) / steps) * (to - from);
        points.emplace_back(at.x(), at.y(), 0);
    }
    return points;
}

Points circle(const Eigen::Vector2d& middle, double radius, int count) {
    Points points;
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * std::numbers::pi * k / count;
        points.emplace_back(middle.x() + radius * std::cos(angle),
                            middle.y() + radius * std::sin(angle), 0);
    }
    return points;
}

/// 200 by 200 mm in the plane z = 0, corner in the origin.
CutShaper squareShaper() {
    return CutShaper(test::asPiece(test::planeGrid(20, 20, 10)));
}

double farthest(const Points& a, const Points& b) {
    double most = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        most = std::max(most, (a[k] - b[k]).norm());
    }
    return most;
}

TEST(Handles, AreEndsSharedPointsAndAMiddle) {
    const UserCut across = handled(UserCut::Kind::Path, straight({0, 100}, {200, 100}, 10));
    EXPECT_EQ(handlesOf({across}, 0), (std::vector<int>{0, 5, 10}));
    const UserCut down = handled(UserCut::Kind::Path, straight({60, 100}, {60, 0}, 4));
    ASSERT_EQ(down.points.front(), across.points[3]);
    EXPECT_EQ(handlesOf({across, down}, 0), (std::vector<int>{0, 3, 10}));
    EXPECT_EQ(handlesOf({across, down}, 1), (std::vector<int>{0, 2, 4}));
    const UserCut dart = handled(UserCut::Kind::Dart, straight({100, 0}, {100, 60}, 6));
    EXPECT_EQ(handlesOf({dart}, 0), (std::vector<int>{0, 6}));
}

TEST(Handles, OfALoopAreFourUnlessItMeetsOthersTwice) {
    UserCut loop = handled(UserCut::Kind::Loop, circle({100, 100}, 60, 16));
    EXPECT_EQ(handlesOf({loop}, 0), (std::vector<int>{0, 4, 8, 12}));
    UserCut first = handled(UserCut::Kind::Path, {loop.points[2], {200, 200, 0}});
    UserCut second = handled(UserCut::Kind::Path, {loop.points[9], {0, 0, 0}});
    EXPECT_EQ(handlesOf({loop, first}, 0), (std::vector<int>{2, 6, 10, 14}));
    EXPECT_EQ(handlesOf({loop, first, second}, 0), (std::vector<int>{2, 9}));
}

TEST(Handles, TakeTheLineAlongUpToTheNextAndNoFarther) {
    const CutShaper shaper = squareShaper();
    std::vector<UserCut> cuts{handled(UserCut::Kind::Path, straight({0, 100}, {200, 100}, 10))};
    const Points before = cuts[0].points;
    shaper.move(cuts, 0, 5, {100, 140, 0});
    EXPECT_EQ(cuts[0].points.front(), before.front());
    EXPECT_EQ(cuts[0].points.back(), before.back());
    for (std::size_t k = 0; k < before.size(); ++k) {
        const double part = 1 - std::abs(static_cast<double>(k) - 5) / 5;
        EXPECT_NEAR(cuts[0].points[k].y(), 100 + 40 * part, 1e-9) << k;
        EXPECT_NEAR(cuts[0].points[k].x(), before[k].x(), 1e-9) << k;
    }
    shaper.move(cuts, 0, 5, before[5]);
    EXPECT_LT(farthest(cuts[0].points, before), 1e-9);
}

TEST(Handles, SharedPointsStaySharedToTheLastBit) {
    const CutShaper shaper = squareShaper();
    const UserCut loop = handled(UserCut::Kind::Loop, circle({100, 100}, 50, 24));
    const UserCut side =
        handled(UserCut::Kind::Path, {loop.points[6], {100, 170, 0}, {100, 200, 0}});
    const UserCut other =
        handled(UserCut::Kind::Path, {{0, 100, 0}, {30, 100, 0}, loop.points[12]});
    std::vector<UserCut> cuts{loop, side, other};
    shaper.move(cuts, 1, 0, {108.3, 161.7, 25});
    EXPECT_EQ(cuts[0].points[6], cuts[1].points[0]);
    EXPECT_LT((cuts[0].points[6] - Eigen::Vector3d(108.3, 161.7, 0)).norm(), 1e-9);
    EXPECT_EQ(cuts[0].points[12], cuts[2].points[2]);  // the next handle of the loop
    EXPECT_EQ(cuts[2].points, other.points);
    EXPECT_NE(cuts[0].points[8], loop.points[8]);
}

TEST(Handles, AnEndOnARimStaysOnRims) {
    const CutShaper shaper = squareShaper();
    std::vector<UserCut> cuts{handled(UserCut::Kind::Path, straight({0, 100}, {100, 100}, 10))};
    shaper.move(cuts, 0, 0, {43, 120, 0});
    EXPECT_LT((cuts[0].points[0] - Eigen::Vector3d(0, 120, 0)).norm(), 1e-9);
    EXPECT_TRUE(shaper.isOnRim(cuts[0].points[0]));
    shaper.move(cuts, 0, 10, {3, 150, 0});  // that end lay inside, and is free
    EXPECT_LT((cuts[0].points[10] - Eigen::Vector3d(3, 150, 0)).norm(), 1e-9);
}

TEST(Handles, LinesStayOnTheSurface) {
    const auto cap = test::asPiece(test::sphericalCap(20, 100, 1.0));
    const CutShaper shaper(cap);
    const NearestSurface nearest(cap->mesh);
    const auto off = [&](const Eigen::Vector3d& p) {
        return (positionOf(cap->mesh, nearest.find(p)) - p).norm();
    };
    Points line;
    for (int k = 0; k <= 12; ++k) {
        const Eigen::Vector3d from = cap->mesh.V.row(0),
                              to = cap->mesh.V.row(cap->mesh.V.rows() - 1);
        line.push_back(positionOf(cap->mesh, nearest.find(from + k / 12.0 * (to - from))));
    }
    std::vector<UserCut> cuts{handled(UserCut::Kind::Path, line)};
    shaper.move(cuts, 0, handlesOf(cuts, 0)[1], line[6] + Eigen::Vector3d(9, -7, 5));
    for (const Eigen::Vector3d& point : cuts[0].points) {
        EXPECT_LT(off(point), 1e-9);
    }
    const Points drawn = shaper.drawn(cuts[0], 3);
    for (std::size_t k = 0; k < drawn.size(); ++k) {
        EXPECT_LT(off(drawn[k]), 1e-9);
        EXPECT_LT(k == 0 ? 0 : (drawn[k] - drawn[k - 1]).norm(), 4);
    }
}

TEST(Handles, ARimIsOfferedWholeAndAlone) {
    const CutShaper shaper(test::asPiece(test::tube(16, 5)));
    const Points rims = shaper.rimThrough(shaper.piece()->mesh.V.row(0).transpose(), 1000);
    ASSERT_FALSE(rims.empty());
    for (const Eigen::Vector3d& point : rims) {
        EXPECT_TRUE(shaper.isOnRim(point));
    }
    EXPECT_EQ(rims.size(), 32U);  // two per edge
    EXPECT_TRUE(squareShaper().rimThrough({100, 100, 0}, 5).empty());
}

TEST(Handles, WhatHasNoRimHasNoneNearIt) {
    const CutShaper shaper(test::asPiece(test::octahedron()));
    const Eigen::Vector3d corner = shaper.piece()->mesh.V.row(0);
    EXPECT_FALSE(shaper.isOnRim(corner));
    EXPECT_EQ(shaper.onRim(corner), corner);
}

}  // namespace
}  // namespace toile
