// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/fresh_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/geometry/polygon.h"
#include "core/quality/measures.h"

namespace toile::prove {
namespace {

Points2 ringOf(double radius, int count, bool clockwise, Eigen::RowVector2d middle = {0, 0}) {
    Points2 ring(count, 2);
    for (int k = 0; k < count; ++k) {
        const double angle = (clockwise ? -2 : 2) * std::numbers::pi * k / count;
        ring.row(k) << middle.x() + radius * std::cos(angle), middle.y() + radius * std::sin(angle);
    }
    return ring;
}

/// A closed line with points in between, about `edge` apart.
Points2 divided(const Points2& corners, double edge) {
    std::vector<Eigen::RowVector2d> points;
    for (Eigen::Index k = 0; k < corners.rows(); ++k) {
        const Eigen::RowVector2d a = corners.row(k), b = corners.row((k + 1) % corners.rows());
        const int parts = std::max(1, static_cast<int>(std::lround((b - a).norm() / edge)));
        for (int i = 0; i < parts; ++i) {
            points.emplace_back(a + (b - a) * i / parts);
        }
    }
    Points2 line(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t k = 0; k < points.size(); ++k) {
        line.row(static_cast<Eigen::Index>(k)) = points[k];
    }
    return line;
}

/// Covers the shape once, with triangles of some quality, and keeps the given points.
void expectGood(const std::vector<Points2>& loops, double edge, double leastAngle = 5) {
    const auto mesh = freshMesh(loops, edge, Subject::piece("front"));
    ASSERT_TRUE(mesh);
    double area = 0;
    Eigen::Index rim = 0;
    for (const Points2& loop : loops) {
        area += geometry::signedAreaOf(loop);
        EXPECT_EQ(mesh->Q.middleRows(rim, loop.rows()), loop);
        rim += loop.rows();
    }
    const Eigen::VectorXd areas = triangleAreas2d(mesh->Q, mesh->F);
    EXPECT_GT(areas.minCoeff(), 0);
    EXPECT_NEAR(areas.sum(), area, 1e-9 * area);
    EXPECT_GT(cornerAngles2d(mesh->Q, mesh->F).minCoeff(), leastAngle * std::numbers::pi / 180);
    const auto again = freshMesh(loops, edge, {});
    EXPECT_EQ(again->Q, mesh->Q);
    EXPECT_EQ(again->F, mesh->F);
}

TEST(FreshMesh, CoversAShapeOnce) {
    expectGood({ringOf(100, 63, false)}, 10);
    Points2 corner(6, 2);
    corner << 0, 0, 200, 0, 200, 80, 70, 80, 70, 160, 0, 160;
    expectGood({divided(corner, 10)}, 10);
    expectGood({divided(corner, 4)}, 4);
}

TEST(FreshMesh, LeavesHolesOpen) {
    expectGood({ringOf(100, 63, false), ringOf(30, 19, true), ringOf(15, 9, true, {60, 10})}, 10);
}

TEST(FreshMesh, FillsNarrowBands) {
    Points2 band(4, 2);
    band << 0, 0, 300, 0, 300, 10, 0, 10;
    expectGood({divided(band, 15)}, 15);
    expectGood({ringOf(60, 25, false), ringOf(50, 25, true)}, 15);
}

TEST(FreshMesh, KeepsTheTwoSidesOfASlitApart) {
    Points2 slit(7, 2);
    slit << 0, 0, 50, 0, 50, 60, 50, 0, 100, 0, 100, 100, 0, 100;
    const Points2 line = divided(slit, 10);
    const auto mesh = freshMesh({line}, 10, {});
    ASSERT_TRUE(mesh);
    EXPECT_NEAR(triangleAreas2d(mesh->Q, mesh->F).sum(), 1e4, 1e-6);
    std::vector<int> uses(static_cast<std::size_t>(mesh->Q.rows()), 0);
    for (const int v : mesh->F.reshaped()) {
        ++uses[v];
    }
    EXPECT_GT(std::ranges::min(uses), 0);
}

TEST(FreshMesh, NamesThePieceWhoseOutlineCrosses) {
    Points2 bow(4, 2);
    bow << 0, 0, 100, 100, 100, 0, 0, 100;
    const auto mesh = freshMesh({bow}, 10, Subject::piece("front"));
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().code, ErrorCode::OutlineCrosses);
    EXPECT_EQ(mesh.error().subject.name, "front");
}

}  // namespace
}  // namespace toile::prove
