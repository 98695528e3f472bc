// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/prepare/file_surface.h"
#include "core/prepare/half.h"
#include "tests/core/prepare/scan_shapes.h"

namespace toile {
namespace {

using Plane = Eigen::Hyperplane<double, 3>;

const Plane kMiddle(Eigen::Vector3d::UnitX(), 0);

/// A skirt's half of x > 0, as a file in centimetres has it.
PolygonSoup halfSkirt() {
    return test::inCentimetres(
        test::part(test::skirt(), [](const Eigen::RowVector3d& middle) { return middle.x() > 0; }));
}

TEST(CompleteHalf, GivesTheWholeWithoutASeam) {
    const auto whole = completeHalf(halfSkirt(), kMiddle, 0.01, 10);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->joined, 2 * 61);  // front and back
    const MeshArrays mesh = surfaceOf(whole->soup, 10).mesh;
    EXPECT_TRUE(isValidSurface(mesh, test::edgesOf(mesh)));
    const std::vector<double> rims = test::perimeters(mesh),
                              known = test::perimeters(test::skirt());
    ASSERT_EQ(rims.size(), 2U);
    EXPECT_NEAR(rims[0], known[0], 1e-6);
    EXPECT_NEAR(test::clothArea(mesh), test::clothArea(test::skirt()), 1e-3);
}

TEST(CompleteHalf, BorderNearThePlaneMovesOntoIt) {
    PolygonSoup half = halfSkirt();
    for (Eigen::Vector3d& position : half.positions) {
        position.x() += position.x() < 0.01 ? 0.02 : 0;  // 0.2 mm off
    }
    EXPECT_FALSE(completeHalf(half, kMiddle, 0.1, 10));
    const auto whole = completeHalf(half, kMiddle, 0.5, 10);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->joined, 2 * 61);
    for (int v = 0; v < static_cast<int>(half.positions.size()); ++v) {
        const Eigen::Vector3d moved = whole->soup.positions[static_cast<std::size_t>(v)] -
                                      half.positions[static_cast<std::size_t>(v)];
        EXPECT_LE(10 * moved.norm(), 0.5);
    }
}

TEST(CompleteHalf, KeepsNamesAndMap) {
    PolygonSoup half = halfSkirt();
    half.groups = {"skirt"};
    half.faceGroup.assign(static_cast<std::size_t>(half.faceCount()), 0);
    half.uvs.assign(1, {0, 0});
    half.cornerUvs.assign(half.corners.size(), 0);
    const auto whole = completeHalf(half, kMiddle, 0.01, 10);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->soup.faceCount(), 2 * half.faceCount());
    EXPECT_EQ(whole->soup.faceGroup.size(), 2 * half.faceGroup.size());
    EXPECT_EQ(whole->soup.cornerUvs.size(), whole->soup.corners.size());
    EXPECT_EQ(whole->soup.cornerUvs.front(), 0);
    EXPECT_EQ(whole->soup.cornerUvs.back(), 1);
    EXPECT_TRUE(std::equal(half.corners.begin(), half.corners.end(), whole->soup.corners.begin()));
}

TEST(CompleteHalf, AWholeGarmentIsNoHalf) {
    EXPECT_FALSE(completeHalf(test::inCentimetres(test::skirt()), kMiddle, 1, 10));
    EXPECT_FALSE(completeHalf({}, kMiddle, 1, 10));
}

}  // namespace
}  // namespace toile
