// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/cut/fill_holes.h"
#include "core/cut/loop_around.h"
#include "tests/core/cut/auto_cut_checks.h"
#include "tests/core/cut/cut_shapes.h"
#include "tests/core/support/generator.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

constexpr int kAround = 60, kRows = 20;

/// A lampshade that turns by a part of a full turn when it is unrolled, from `inner` to 300 mm
/// along its slant.
MeshArrays lampshade(double turn, double inner) {
    std::vector<Eigen::Vector2d> profile;
    for (int k = 0; k <= kRows; ++k) {
        const double slant = inner + (300 - inner) * k / kRows;
        profile.emplace_back(turn * slant, -std::sqrt(1 - turn * turn) * slant);
    }
    return test::revolution(profile, kAround);
}

/// Of the longest rim as the outline, and the others as holes.
std::vector<double> strains(const MeshArrays& mesh) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    const SurfaceLinks links(mesh, table);
    std::vector<RimLoop> rims = rimsOf(links.mesh(), links.table());
    std::ranges::sort(rims, std::ranges::greater(), &RimLoop::perimeter);
    const RimLoop outline = rims.front();
    rims.erase(rims.begin());
    return strainsAcross(links, outline, rims, 0);
}

int cutsOf(const MeshArrays& mesh) {
    return static_cast<int>(test::expectOneDisk(mesh, "ring").cuts.size());
}

/// Everything moves by some millimetres in the plane of the ring.
MeshArrays ragged(MeshArrays mesh, double most) {
    test::Generator random(7);
    for (auto row : mesh.V.rowwise()) {
        row[0] += random.between(-most, most);
        row[2] += random.between(-most, most);
    }
    return mesh;
}

TEST(RingWidth, OfALampshadeFollowsFromHowFarItTurns) {
    // Its rims are 2 pi turn (300 - inner) apart in length, and 300 - inner on the cloth.
    for (const double turn : {0.8, 0.9, 1.0}) {
        for (const double inner : {60, 180, 270}) {
            const auto strain = strains(lampshade(turn, inner));
            ASSERT_EQ(strain.size(), 1U);
            EXPECT_NEAR(strain[0], 1 / turn - 1, inner < 200 ? 0.01 : 0.3);
            EXPECT_LE(strain[0], 1 / turn - 1 + 0.01);
        }
    }
}

TEST(RingWidth, LeavesFlatClothAlone) {
    const auto isHole = [](double x, double y, double radius) {
        return [=](const Eigen::RowVector3d& middle) {
            return std::hypot(middle.x() - x, middle.y() - y) > radius;
        };
    };
    const MeshArrays cloth = test::planeGrid(30, 30, 10);
    for (const double x : {150.0, 90.0, 60.0}) {  // in the middle and near the edge
        EXPECT_EQ(cutsOf(test::part(cloth, isHole(x, 150, 45))), 0) << x;
    }
    const MeshArrays vest =
        test::part(test::part(test::part(cloth, isHole(150, 150, 30)), isHole(60, 150, 35)),
                   isHole(240, 150, 35));
    EXPECT_EQ(cutsOf(vest), 0);
    EXPECT_EQ(cutsOf(test::revolution({{40, 0}, {60, 0}, {150, 0}}, 7)), 0);  // coarse
    EXPECT_EQ(cutsOf(ragged(lampshade(1, 100), 4)), 0);
}

TEST(RingWidth, LeavesClothThatIsBentOrDishedALittleAlone) {
    MeshArrays poncho = test::part(test::planeGrid(30, 30, 10), [](const Eigen::RowVector3d& at) {
        return std::hypot(at.x() - 150, at.y() - 150) > 50;
    });
    for (auto row : poncho.V.rowwise()) {  // over a cylinder of 60 mm
        row = Eigen::RowVector3d(60 * std::sin(row.x() / 60), row.y(), 60 * std::cos(row.x() / 60))
                  .eval();
    }
    EXPECT_EQ(cutsOf(poncho), 0);
    std::vector<Eigen::Vector2d> cap;
    for (int k = 3; k <= 20; ++k) {
        const double angle = std::numbers::pi / 5 * k / 20;
        cap.emplace_back(200 * std::sin(angle), 200 * std::cos(angle));
    }
    EXPECT_EQ(cutsOf(test::revolution(cap, kAround)), 0);
}

TEST(RingWidth, ATubeThatTurnsAlmostOnceIsCut) {
    EXPECT_EQ(cutsOf(lampshade(0.8, 60)), 1);
    EXPECT_EQ(cutsOf(lampshade(0.8, 180)), 1);
    EXPECT_EQ(cutsOf(ragged(lampshade(0.78, 60), 4)), 1);
    EXPECT_EQ(cutsOf(lampshade(0.9, 60)), 0);
}

TEST(RingWidth, BothEndsOfATubeMayLieFlat) {
    // A hat with a brim and an open crown: rings at both ends, and a tube between.
    std::vector<Eigen::Vector2d> hat;
    for (int k = 0; k <= 30; ++k) {
        const double way = 10.0 * k;
        hat.push_back(way < 60    ? Eigen::Vector2d(30 + way, 100)
                      : way < 160 ? Eigen::Vector2d(90, 160 - way)
                                  : Eigen::Vector2d(way - 70, 0));
    }
    EXPECT_GT(strains(test::revolution(hat, kAround))[0], 0.45);
    EXPECT_EQ(cutsOf(test::revolution(hat, kAround)), 1);
}

}  // namespace
}  // namespace toile
