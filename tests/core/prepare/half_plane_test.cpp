// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/progress.h"
#include "core/prepare/half.h"
#include "tests/core/prepare/scan_shapes.h"
#include "tests/core/support/half_shapes.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

using Plane = Eigen::Hyperplane<double, 3>;

PolygonSoup halfPlaneInput(const std::filesystem::path& file) {
    Progress progress;
    auto soup = readSoup(file, progress);
    EXPECT_TRUE(soup) << file;
    return soup ? *std::move(soup) : PolygonSoup{};
}

Eigen::AlignedBox3d boxOf(const PolygonSoup& soup) {
    Eigen::AlignedBox3d box;
    for (const int corner : soup.corners) {
        box.extend(soup.positions[static_cast<std::size_t>(corner)]);
    }
    return box;
}

std::optional<HalfPlane> offered(const PolygonSoup& soup, UpAxis up = UpAxis::Y) {
    return findHalfPlane(surfaceOf(soup, 1), up, false);
}

class HalfPlaneOfGarment : public testing::TestWithParam<const char*> {};

TEST_P(HalfPlaneOfGarment, IsFoundInItsHalfAlone) {
    const auto file = test::dataFile(GetParam());
    TOILE_NEEDS_SHARED(file);
    const PolygonSoup whole = halfPlaneInput(file);
    EXPECT_FALSE(offered(whole));
    const Eigen::AlignedBox3d box = boxOf(whole);
    const double tolerance = 2e-3 * box.diagonal().norm();
    for (const double turn : {0.0, 0.4}) {
        const Plane plane(Eigen::Vector3d(std::cos(turn), 0, std::sin(turn)), box.center());
        const PolygonSoup half = test::halfOf(whole, plane);
        const auto found = offered(half);
        ASSERT_TRUE(found) << turn;
        EXPECT_GT(found->plane.normal().dot(plane.normal()), 0.999);
        EXPECT_LT(plane.absDistance(found->plane.projection(box.center())), tolerance);
        EXPECT_GT(found->length, box.sizes().y() / 2);
        EXPECT_FALSE(found->isCompleted);
        // The same garment as a program with z up writes it.
        PolygonSoup standing = half;
        for (Eigen::Vector3d& position : standing.positions) {
            position = Eigen::Vector3d(position.x(), -position.z(), position.y());
        }
        const auto turned = offered(standing, UpAxis::Z);
        ASSERT_TRUE(turned) << turn;
        EXPECT_NEAR(turned->length, found->length, 1e-6 * found->length);
        EXPECT_EQ(turned->plane.normal().z(), 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, HalfPlaneOfGarment,
                         testing::Values("samples/bodice.obj", "samples/skirt.obj",
                                         "samples/trousers.obj", "samples/tshirt.obj"));
INSTANTIATE_TEST_SUITE_P(Shared, HalfPlaneOfGarment,
                         testing::Values("garments/dress.obj", "garments/leggings.ply",
                                         "garments/longsleeve.obj", "garments/polo.obj",
                                         "garments/skirt_clo.obj", "garments/tee_sim.obj",
                                         "garments/tshirt.obj"));

TEST(HalfPlane, IsTheFilesOwnWhereThatFits) {
    PolygonSoup half = test::halfOf(halfPlaneInput(test::dataFile("samples/tshirt.obj")),
                                    Plane(Eigen::Vector3d::UnitX(), 0));
    int turn = 0;
    for (Eigen::Vector3d& position : half.positions) {
        position.x() += position.x() == 0 ? (turn++ % 3) * 1e-5 : 0;  // digits
    }
    const auto found = offered(half);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->plane.normal(), Eigen::Vector3d::UnitX());
    EXPECT_EQ(found->plane.offset(), 0);
}

TEST(HalfPlane, LevelRimsAndOpeningsAreNone) {
    const MeshArrays skirt = test::skirt();
    const PolygonSoup upper =
        test::inCentimetres(test::part(skirt, [](const Eigen::RowVector3d& middle) {
            return middle.y() > test::kSkirtHeight / 2;
        }));
    MeshArrays sleeve = skirt;  // along x, as of a garment with its arms stretched out
    sleeve.V.col(0).swap(sleeve.V.col(1));
    for (const bool isStated : {false, true}) {
        EXPECT_FALSE(findHalfPlane(surfaceOf(upper, 10), UpAxis::Y, isStated));
        EXPECT_FALSE(findHalfPlane({sleeve, {}}, UpAxis::Y, isStated));
        EXPECT_FALSE(findHalfPlane({test::octahedron(), {}}, UpAxis::Y, isStated));
        EXPECT_FALSE(findHalfPlane({}, UpAxis::Y, isStated));
    }
}

TEST(HalfPlane, PanelsThatAreNotSewnYetAreNone) {
    const MeshArrays panel = test::planeGrid(8, 12, 20);
    const MeshArrays pair = test::beside(panel, panel, {0, 0, 100});
    EXPECT_FALSE(findHalfPlane({pair, {}}, UpAxis::Y, false));
    EXPECT_FALSE(findHalfPlane({pair, {}}, UpAxis::Z, false));  // lying on each other
}

/// A half of a tube of this radius, its rims in the plane z = 0.
MeshArrays halfTube(double radius) {
    MeshArrays strip = test::planeGrid(16, 10, 30);
    for (int v = 0; v < strip.V.rows(); ++v) {
        const double turn = M_PI * strip.V(v, 0) / (16 * 30);
        strip.V.row(v) << -radius * std::cos(turn), strip.V(v, 1), radius * std::sin(turn);
    }
    return strip;
}

TEST(HalfPlane, GoesRoundOnceWithItsLiningAndNotTwice) {
    const MeshArrays strip = halfTube(150);
    const MeshArrays lined = test::beside(strip, halfTube(140), {0, 0, 0});
    const MeshArrays two = test::beside(strip, strip, {400, 0, 0});
    EXPECT_TRUE(findHalfPlane({strip, {}}, UpAxis::Y, false));
    EXPECT_TRUE(findHalfPlane({lined, {}}, UpAxis::Y, false));
    EXPECT_FALSE(findHalfPlane({two, {}}, UpAxis::Y, false));
    EXPECT_TRUE(findHalfPlane({two, {}}, UpAxis::Y, true));
}

TEST(HalfPlane, OfOneFlatPanelIsFoundWhereItIsStated) {
    MeshArrays panel = test::planeGrid(8, 12, 20);
    EXPECT_FALSE(findHalfPlane({panel, {}}, UpAxis::Y, false));
    const auto found = findHalfPlane({panel, {}}, UpAxis::Y, true);
    ASSERT_TRUE(found);
    EXPECT_EQ(std::abs(found->plane.normal().x()), 1);
}

}  // namespace
}  // namespace toile
