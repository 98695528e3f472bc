// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/symmetry/mirror_plane.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/symmetry/mirror_shapes.h"

namespace toile {
namespace {

/// Whether two planes are one, whatever their normals' senses: at three points, mm.
void expectSamePlane(const MirrorPlane& plane, const MirrorPlane& wanted, double tolerance) {
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d p = 300 * Eigen::Vector3d::Unit(k);
        EXPECT_LT((plane.reflected(p) - wanted.reflected(p)).norm(), tolerance);
    }
}

MirrorPlane planeOf(const Garment& garment) {
    const auto plane = findMirrorPlane(garment.pieces);
    EXPECT_TRUE(plane);
    return plane.value_or(MirrorPlane{});
}

TEST(MirrorPlane, OfAnExactMirrorImage) {
    // The diagonals are no mirror images, so the rounds come near the plane but do not reach it.
    const MirrorPlane plane = planeOf(test::tube4());
    expectSamePlane(plane, {{1, 0, 0}, 0}, 1e-3);
    EXPECT_LT(plane.farthest, 1e-3);
}

TEST(MirrorPlane, DoesNotDependOnTheTriangles) {
    const MirrorPlane plane = planeOf(test::tube4({}, 37));
    expectSamePlane(plane, {{1, 0, 0}, 0}, 0.5);
    EXPECT_LT(plane.deviation, 0.2);
}

TEST(MirrorPlane, OfClothThatHangs) {
    const MirrorPlane plane = planeOf(test::tube4(test::draped));
    EXPECT_GT(std::abs(plane.normal.x()), 0.999);
    EXPECT_LT(plane.deviation, 6);
    EXPECT_GE(plane.farthest, plane.deviation);
}

TEST(MirrorPlane, FollowsTheGarment) {
    const MirrorPlane before = planeOf(test::tube4(test::draped));
    const MirrorPlane after =
        planeOf(test::tube4([](const auto& p) { return test::moved(test::draped(p)); }));
    MirrorPlane wanted = before;
    wanted.normal = test::turned(before.normal);
    wanted.offset = wanted.normal.dot(test::moved(before.offset * before.normal));
    expectSamePlane(after, wanted, 1e-5);
    EXPECT_NEAR(after.deviation, before.deviation, 1e-6);
    EXPECT_NEAR(after.farthest, before.farthest, 1e-5);
}

TEST(MirrorPlane, OfTheReflectedGarment) {
    const MirrorPlane before = planeOf(test::tube4(test::draped));
    const MirrorPlane mirror{Eigen::Vector3d(1, 2, -1).normalized(), 40};
    const MirrorPlane after =
        planeOf(test::tube4([&](const auto& p) { return mirror.reflected(test::draped(p)); }));
    MirrorPlane wanted = before;
    const Eigen::Vector3d on = mirror.reflected(before.offset * before.normal);
    wanted.normal = before.normal - 2 * mirror.normal.dot(before.normal) * mirror.normal;
    wanted.offset = wanted.normal.dot(on);
    expectSamePlane(after, wanted, 1e-5);
    EXPECT_NEAR(after.deviation, before.deviation, 1e-6);
}

TEST(MirrorPlane, DoesNotDependOnTheOrderOfPieces) {
    const Garment garment = test::tube4(test::draped);
    expectSamePlane(planeOf(test::inOppositeOrder(garment)), planeOf(garment), 1e-6);
}

TEST(MirrorPlane, IsNotThatInWhichAFlatGarmentLies) {
    Garment garment;
    garment.pieces = {test::asPiece(test::planeGrid(6, 12, 40), "panel")};
    const MirrorPlane plane = planeOf(garment);
    EXPECT_LT(std::abs(plane.normal.z()), 1e-9);
    EXPECT_LT(plane.deviation, 1);
}

TEST(MirrorPlane, NoneOfAScrew) {
    MeshArrays mesh = test::planeGrid(60, 4, 1);
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
        const double angle = 0.12 * mesh.V(v, 0), radius = 40 + 30 * mesh.V(v, 1);
        mesh.V.row(v) << radius * std::cos(angle), 60 * angle, radius * std::sin(angle);
    }
    Garment garment;
    garment.pieces = {test::asPiece(std::move(mesh), "ribbon")};
    EXPECT_FALSE(findMirrorPlane(garment.pieces));
}

TEST(MirrorPlane, NoneWithoutCloth) {
    EXPECT_FALSE(findMirrorPlane({}));
}

TEST(MirrorPlane, NoneOnceCancelled) {
    Progress progress;
    progress.cancel();
    EXPECT_FALSE(findMirrorPlane(test::tube4().pieces, progress));
}

class MirrorPlaneOfSample : public testing::TestWithParam<const char*> {};

TEST_P(MirrorPlaneOfSample, IsTheOneItWasMadeWith) {
    const MirrorPlane plane = planeOf(test::garmentOf(GetParam()));
    expectSamePlane(plane, {{1, 0, 0}, 0}, 1e-9);
    EXPECT_LT(plane.farthest, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Samples, MirrorPlaneOfSample,
                         testing::Values("samples/tshirt.obj", "samples/bodice.obj",
                                         "samples/trousers.obj", "samples/cap.obj",
                                         "samples/skirt.obj"));

struct Draped {
    const char* file;
    double deviation, farthest;  ///< mm, to a tenth
};

class MirrorPlaneOfDraped : public testing::TestWithParam<Draped> {};

TEST_P(MirrorPlaneOfDraped, DeviatesAsMeasured) {
    TOILE_NEEDS_SHARED(test::dataFile(GetParam().file));
    const MirrorPlane plane = planeOf(test::garmentOf(GetParam().file));
    EXPECT_GT(std::abs(plane.normal.x()), 0.995);
    EXPECT_NEAR(plane.deviation, GetParam().deviation, 0.1 * GetParam().deviation);
    EXPECT_NEAR(plane.farthest, GetParam().farthest, 0.1 * GetParam().farthest);
}

INSTANTIATE_TEST_SUITE_P(Garments, MirrorPlaneOfDraped,
                         testing::Values(Draped{"garments/tee_sim.obj", 6.5, 27.4},
                                         Draped{"garments/dress.obj", 16.3, 74.8},
                                         Draped{"garments/polo.obj", 6.4, 31.2}));

}  // namespace
}  // namespace toile
