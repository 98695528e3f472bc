// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs to stretch, shear and bend cloth.
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/sew/bending.h"
#include "core/sew/membrane.h"
#include "tests/core/sew/cloth_shapes.h"

namespace toile::sew {
namespace {

const ClothStiffness kOrthotropic{800, 2000, 250, 90, 2e-5};

Eigen::MatrixXd dense(const SpaceMatrix& H) {
    const linalg::SymmetricMatrix& m = H.matrix();
    Eigen::MatrixXd full = Eigen::MatrixXd::Zero(m.size, m.size);
    for (int c = 0; c < m.size; ++c) {
        for (int i = m.columnStart[c]; i < m.columnStart[c + 1]; ++i) {
            full(m.row[i], c) = full(c, m.row[i]) = m.value[i];
        }
    }
    return full;
}

Points3 asField(const Eigen::VectorXd& x) {
    return Eigen::Map<const Points3>(x.data(), x.size() / 3, 3);
}

/// The energy's derivative by differences.
template <class Term>
Points3 differences(const Term& term, const Points3& X) {
    constexpr double kStep = 1e-4;
    Points3 slopes(X.rows(), 3);
    for (Eigen::Index i = 0; i < X.size(); ++i) {
        Points3 more = X, less = X;
        more.data()[i] += kStep;
        less.data()[i] -= kStep;
        slopes.data()[i] = (term.energy(more) - term.energy(less)) / (2 * kStep);
    }
    return slopes;
}

template <class Term>
Points3 gradientOf(const Term& term, const Points3& X) {
    Points3 g = Points3::Zero(X.rows(), 3);
    term.addGradient(X, g);
    return g;
}

template <class Term>
SpaceMatrix emptyMatrix(const Term& term, const Points3& X) {
    std::vector<std::pair<int, int>> pairs;
    term.addPairs(pairs);
    return {pairs, static_cast<int>(X.rows())};
}

TEST(ClothEnergy, MembraneStretchedAlongEitherThreadHasItsExactEnergyAndForce) {
    const Cloth cloth = sewTogether(test::flatCloth(3, 3, 10));
    const Membrane membrane(cloth, {kOrthotropic});
    for (const int thread : {0, 1}) {
        constexpr double kStretch = 1.1;
        Points3 X = cloth.X;
        X.col(thread) *= kStretch;
        const double green = (kStretch * kStretch - 1) / 2;
        const double modulus = (thread == 0 ? kOrthotropic.weft : kOrthotropic.warp) / 1000;
        EXPECT_NEAR(membrane.energy(X), 900 * modulus * green * green / 2, 1e-9);
        // What holds one end: width x stress x stretch.
        const Points3 g = gradientOf(membrane, X);
        double held = 0;
        for (Eigen::Index v = 0; v < X.rows(); ++v) {
            held += cloth.X(v, thread) > 29 ? g(v, thread) : 0;
        }
        EXPECT_NEAR(held, 30 * modulus * green * kStretch, 1e-9);
    }
}

TEST(ClothEnergy, MembraneShearedHasItsExactEnergy) {
    const Cloth cloth = sewTogether(test::flatCloth(2, 2, 10));
    constexpr double kShear = 0.2;
    Points3 X = cloth.X;  // threads keep their lengths: x along the weft, the warp turned
    for (Eigen::Index v = 0; v < X.rows(); ++v) {
        const double y = X(v, 1);
        X(v, 0) += std::sin(kShear) * y;
        X(v, 1) = std::cos(kShear) * y;
    }
    const double angle = std::sin(kShear);  // 2 E12
    EXPECT_NEAR(Membrane(cloth, {kOrthotropic}).energy(X), 400 * 0.09 * angle * angle / 2, 1e-9);
}

TEST(ClothEnergy, RigidMotionsCostNothing) {
    const Cloth cloth = sewTogether(test::coneCloth(9, 2, 40, 90, 0.5));
    const Membrane membrane(cloth, {kOrthotropic});
    const Bending bending(cloth, {kOrthotropic});
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    Points3 moved = cloth.X * turn.transpose();
    moved.rowwise() += Eigen::RowVector3d(5, -70, 300);
    EXPECT_NEAR(membrane.energy(moved), 0, 1e-20);
    EXPECT_NEAR(gradientOf(membrane, moved).norm(), 0, 1e-10);
    EXPECT_NEAR(bending.energy(moved), bending.energy(cloth.X), 1e-9 * bending.energy(cloth.X));
    EXPECT_GT(bending.energy(moved), 0);
}

TEST(ClothEnergy, GradientsAreTheEnergiesDerivatives) {
    const Cloth cloth = sewTogether(test::tubeCloth(5, 2, 30, 40));
    const Points3 X = test::shaken(cloth.X, 3, 7);
    const Membrane membrane(cloth, {kOrthotropic});
    const Bending bending(cloth, {kOrthotropic});
    const Points3 m = differences(membrane, X), b = differences(bending, X);
    EXPECT_NEAR((gradientOf(membrane, X) - m).norm(), 0, 1e-6 * m.norm());
    EXPECT_NEAR((gradientOf(bending, X) - b).norm(), 0, 1e-6 * b.norm());
}

TEST(ClothEnergy, HessiansAreTheGradientsDerivativesWhereAllIsTense) {
    const Cloth cloth = sewTogether(test::tubeCloth(5, 2, 30, 40));
    const Points3 X = test::shaken(1.3 * cloth.X, 0.5, 3);
    const Membrane membrane(cloth, {kOrthotropic});
    const Bending bending(cloth, {kOrthotropic});
    SpaceMatrix ofMembrane = emptyMatrix(membrane, X), ofBending = emptyMatrix(bending, X);
    membrane.addHessian(X, ofMembrane);
    bending.addHessian(ofBending);
    constexpr double kStep = 1e-4;
    const Points3 P = test::shaken(Points3::Zero(X.rows(), 3), 1, 5);
    const Eigen::VectorXd p = Eigen::Map<const Eigen::VectorXd>(P.data(), P.size());
    const Points3 m = (gradientOf(membrane, Points3(X + kStep * P)) -
                       gradientOf(membrane, Points3(X - kStep * P))) /
                      (2 * kStep);
    const Points3 b = gradientOf(bending, P);
    EXPECT_NEAR((asField(dense(ofMembrane) * p) - m).norm(), 0, 1e-6 * m.norm());
    EXPECT_NEAR((asField(dense(ofBending) * p) - b).norm(), 0, 1e-9 * b.norm());
}

TEST(ClothEnergy, HessiansArePositiveSemidefiniteWhereClothIsPressed) {
    const Cloth cloth = sewTogether(test::flatCloth(3, 2, 10));
    const Membrane membrane(cloth, {kOrthotropic});
    const Points3 X = test::shaken(0.8 * cloth.X, 3, 11);
    SpaceMatrix H = emptyMatrix(membrane, X);
    membrane.addHessian(X, H);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(dense(H));
    EXPECT_GT(solver.eigenvalues().minCoeff(), -1e-12 * solver.eigenvalues().maxCoeff());
}

TEST(ClothEnergy, BendingToACylinderCostsHalfTheStiffnessTimesTheCurvatureSquared) {
    constexpr double kRadius = 50;
    constexpr int kColumns = 120;
    CutCloth cut = test::tubeCloth(kColumns, 2, kRadius, 20);
    const Cloth closed = sewTogether(cut);
    cut.sewn.clear();
    const Cloth open = sewTogether(cut);
    // Every ruling bends but the two ends, sewn or not: a seam is a hinge.
    const double area = 2 * std::numbers::pi * kRadius * 20 * (kColumns - 1) / kColumns;
    const double expected = 2e-2 * area / (2 * kRadius * kRadius);
    EXPECT_NEAR(Bending(open, {kOrthotropic}).energy(open.X), expected, 1e-3 * expected);
    EXPECT_NEAR(Bending(closed, {kOrthotropic}).energy(closed.X), expected, 1e-3 * expected);
}

TEST(ClothEnergy, BendingStrainsNothingThatIsFlat) {
    const Cloth cloth = sewTogether(test::flatCloth(3, 3, 10));
    const Bending bending(cloth, {});
    Points3 slanted = cloth.X;
    slanted.col(2) = 0.3 * slanted.col(0) - 2 * slanted.col(1);
    EXPECT_NEAR(bending.energy(slanted), 0, 1e-20);
    EXPECT_TRUE(Bending(cloth, {isotropicStiffness(1000, 0.3, 0)}).empty());
}

}  // namespace
}  // namespace toile::sew
