// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/contact.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/core/sew/cloth_shapes.h"

namespace toile::sew {
namespace {

TEST(Contact, DistancesFromACubeAreSigned) {
    const WornSurface cube(sewTogether(test::cubeCloth(2, 100)).surface());
    EXPECT_NEAR(cube.placeOf({0, 3, 60}).distance, 10, 1e-12);
    EXPECT_NEAR(cube.placeOf({0, 3, 45}).distance, -5, 1e-12);
    const auto edge = cube.placeOf({53, 4, 54});
    EXPECT_NEAR(edge.distance, 5, 1e-12);
    EXPECT_NEAR((edge.away - Eigen::Vector3d(0.6, 0, 0.8)).norm(), 0, 1e-12);
    EXPECT_NEAR(cube.placeOf({52, -52, 51}).distance, 3, 1e-12);
    const auto corner = cube.placeOf({50, 50, 50});
    EXPECT_NEAR(corner.distance, 0, 1e-12);
    EXPECT_NEAR((corner.away - Eigen::Vector3d::Constant(1 / std::sqrt(3.0))).norm(), 0, 1e-12);
}

TEST(Contact, GoesOnPastARim) {
    const WornSurface plane(sewTogether(test::flatCloth(2, 2, 10)).surface());
    const auto beyond = plane.placeOf({35, 5, 2});
    EXPECT_NEAR(beyond.distance, 2, 1e-12);
    EXPECT_NEAR((beyond.away - Eigen::Vector3d::UnitZ()).norm(), 0, 1e-12);
    EXPECT_NEAR(plane.placeOf({-8, -8, -3}).distance, -3, 1e-12);
    EXPECT_NEAR(plane.distanceTo({23, 5, 4}), 5, 1e-12);
}

TEST(Contact, PastACornerOfTheRimTheRoundingGoesOn) {
    const WornSurface tube(sewTogether(test::tubeCloth(8, 2, 50, 80)).surface());
    for (const double turn : {0.0, 0.1, std::numbers::pi / 8}) {
        for (const double past : {0.0, 7.0}) {
            const Eigen::Vector3d radial(std::sin(turn), 0, std::cos(turn));
            const Eigen::Vector3d p(50 * Eigen::Vector3d::UnitZ() + 5 * radial +
                                    (80 + past) * Eigen::Vector3d::UnitY());
            const auto place = tube.placeOf(p);
            EXPECT_NEAR(place.distance, 5, 1e-9) << turn << " " << past;
            EXPECT_NEAR((place.away - radial).norm(), 0, 1e-9) << turn << " " << past;
        }
    }
}

TEST(Contact, TurnsAboutEdgesAndCornersAsItsGradientDoes) {
    const WornSurface cube(sewTogether(test::cubeCloth(2, 100)).surface());
    constexpr double kStep = 1e-5;
    for (const Eigen::Vector3d& p :
         {Eigen::Vector3d(53, 4, 54), Eigen::Vector3d(52, -52, 51), Eigen::Vector3d(7, 4, 60)}) {
        const auto place = cube.placeOf(p);
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(k);
            const Eigen::Vector3d turned =
                (cube.placeOf(p + step).away - cube.placeOf(p - step).away) / (2 * kStep);
            EXPECT_NEAR((place.bend.col(k) - turned).norm(), 0, 1e-8);
        }
    }
}

TEST(Contact, GradientIsTheEnergysDerivativeInsideAndOutside) {
    const WornSurface cube(sewTogether(test::cubeCloth(2, 100)).surface());
    Points3 X(4, 3);
    X << 7, 3, 60, -55, -57, 10, 13, 49, 5, 52, 55, 51;
    const Contact contact(cube, Eigen::Vector4d(3, 5, 7, 2), {1e-3, 0.2});
    Points3 g = Points3::Zero(4, 3);
    contact.addGradient(contact.placesOf(X), g);
    constexpr double kStep = 1e-5;
    for (Eigen::Index i = 0; i < X.size(); ++i) {
        Points3 more = X, less = X;
        more.data()[i] += kStep;
        less.data()[i] -= kStep;
        const double slope =
            (contact.energy(contact.placesOf(more)) - contact.energy(contact.placesOf(less))) /
            (2 * kStep);
        EXPECT_NEAR(g.data()[i], slope, 1e-8) << i;
    }
}

TEST(Contact, AStepDownToTheSurfaceEndsWhereAVertexRestsAlone) {
    const WornSurface plane(sewTogether(test::flatCloth(2, 2, 10)).surface());
    constexpr double kPressure = 1e-3, kStiffness = 0.2;
    const Contact contact(plane, Eigen::VectorXd::Constant(1, 4), {kPressure, kStiffness});
    for (const double height : {5.0, 0.011, 0.004, -0.004}) {
        const Points3 X = Eigen::RowVector3d(11, 8, height);
        const auto places = contact.placesOf(X);
        Points3 g = Points3::Zero(1, 3);
        contact.addGradient(places, g);
        SpaceMatrix H({}, 1);
        contact.addHessian(places, 1, H);
        const double curvature = H.matrix().value.back();
        EXPECT_NEAR(height - g(0, 2) / curvature, kPressure / kStiffness, 1e-12);
    }
}

TEST(Contact, PressedIntoAnInwardEdgeIsAsStiffAsItsForceTurns) {
    MeshArrays room = sewTogether(test::cubeCloth(2, 100)).surface();
    room.F.col(1).swap(room.F.col(2));  // the walls of a room
    const WornSurface walls(room);
    const Contact contact(walls, Eigen::VectorXd::Constant(1, 4), {1e-3, 0.2});
    const Points3 X = Eigen::RowVector3d(50.3, 4, 50.4);  // in a corner between two of them
    EXPECT_NEAR(walls.placeOf(X.transpose()).distance, -0.5, 1e-12);
    SpaceMatrix H({}, 1);
    contact.addHessian(contact.placesOf(X), 1, H);
    Eigen::Matrix3d full;
    const std::vector<double>& value = H.matrix().value;
    full << value[0], value[1], value[2], value[1], value[3], value[4], value[2], value[4],
        value[5];
    constexpr double kStep = 1e-5;
    for (int k = 0; k < 3; ++k) {
        Points3 more = X, less = X, g = Points3::Zero(1, 3);
        more(0, k) += kStep;
        less(0, k) -= kStep;
        contact.addGradient(contact.placesOf(less), g);
        g = -g;
        contact.addGradient(contact.placesOf(more), g);
        EXPECT_NEAR((full.col(k) - g.transpose() / (2 * kStep)).norm(), 0, 1e-6) << k;
    }
}

TEST(Contact, AVertexKeepsToItsSheet) {
    const MeshArrays sheet = sewTogether(test::flatCloth(2, 2, 10)).surface();
    MeshArrays two;
    two.V.resize(2 * sheet.V.rows(), 3);
    two.V << sheet.V, sheet.V;
    two.V.bottomRows(sheet.V.rows()).col(2).array() += 2;
    two.F.resize(2 * sheet.F.rows(), 3);
    two.F << sheet.F, (sheet.F.array() + static_cast<int>(sheet.V.rows())).matrix();
    const WornSurface sheets(two);
    const Contact contact(sheets, Eigen::VectorXd::Constant(1, 4), {1e-3, 0.2});
    const Points3 before = Eigen::RowVector3d(7, 8, 0.9), after = Eigen::RowVector3d(7, 8, 1.1);
    const auto places = contact.placesOf(before);
    EXPECT_NEAR(places[0].distance, 0.9, 1e-12);
    EXPECT_NEAR(contact.placesOf(after)[0].distance, -0.9, 1e-12);
    EXPECT_NEAR(contact.placesOf(after, before, places)[0].distance, 1.1, 1e-12);
}

TEST(Contact, AFaceWithoutAreaLooksWhereItsNeighboursDo) {
    MeshArrays mesh;
    mesh.V.resize(5, 3);
    mesh.V << 0, 0, 0, 10, 0, 0, 5, 0, 0, 0, 10, 0, 10, -10, 0;
    mesh.F.resize(3, 3);
    mesh.F << 0, 2, 1, 0, 1, 3, 1, 0, 4;  // the first lies on the edge of the other two
    mesh.F.row(0) << 0, 1, 2;
    const WornSurface surface(mesh);
    for (const double x : {2.0, 5.0, 7.0}) {
        const auto place = surface.placeOf({x, 0, 3});
        EXPECT_NEAR(place.distance, 3, 1e-12);
        EXPECT_NEAR(place.away.z(), 1, 1e-12);
    }
}

}  // namespace
}  // namespace toile::sew
