// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/self_contact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/sew/cloth_forces.h"
#include "core/sew/settle.h"
#include "tests/core/sew/cloth_shapes.h"

namespace toile::sew {
namespace {

/// Two rectangles, the second above or beside the first.
CutCloth twoSheets(int columns, int rows, double size, const Eigen::RowVector3d& apart) {
    CutCloth cut = test::flatCloth(columns, rows, size);
    const Eigen::Index points = cut.Q.rows(), faces = cut.F.rows();
    cut.Q = cut.Q.replicate(2, 1).eval();
    cut.V = cut.V.replicate(2, 1).eval();
    cut.V.bottomRows(points).rowwise() += apart;
    cut.F = cut.F.replicate(2, 1).eval();
    cut.F.bottomRows(faces).array() += static_cast<int>(points);
    cut.pieceOf.insert(cut.pieceOf.end(), static_cast<std::size_t>(faces), 1);
    return cut;
}

/// A book that stands half open: two pages sewn along the z axis, the first lies at y = 0.
CutCloth openBook(int squares, double size, double angle) {
    CutCloth cut = twoSheets(squares, squares, size, {0, 0, 0});
    const Eigen::Index points = cut.Q.rows() / 2;
    for (Eigen::Index v = 0; v < points; ++v) {
        cut.V.row(v) << cut.Q(v, 0), 0, -cut.Q(v, 1);
        cut.V.row(points + v) << cut.Q(v, 0) * std::cos(angle), cut.Q(v, 0) * std::sin(angle),
            -cut.Q(v, 1);
    }
    for (int j = 0; j <= squares; ++j) {
        cut.sewn.emplace_back(j, static_cast<int>(points) + j);
    }
    return cut;
}

WornSurface table() {
    MeshArrays mesh = sewTogether(test::flatCloth(4, 4, 250)).surface();
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
        mesh.V.row(v) = Eigen::RowVector3d(mesh.V(v, 0) - 500, 0, 500 - mesh.V(v, 1)).eval();
    }
    return WornSurface(mesh);
}

SettleOptions fallingCloth() {
    SettleOptions options;
    options.pressure = 0;
    options.gravity = 9.81;
    options.stiffness.assign(2, isotropicStiffness(300, 0.3, 1e-6));
    options.touchesItself = true;
    options.maxIterations = 600;
    return options;
}

TEST(SelfContact, PushesWithTheEnergysDerivative) {
    const Cloth cloth = sewTogether(twoSheets(4, 4, 10, {2.5, 1.3, 6}));
    Points3 X = test::shaken(cloth.X, 0.3, 3);
    X.bottomRows(X.rows() / 2).col(2).array() -= 5.4;
    const SelfContact contact(cloth, 1, 1);
    const auto touches = contact.touchesAt(X, 1);
    ASSERT_GT(touches.size(), 20U);
    Points3 g = Points3::Zero(X.rows(), 3);
    contact.addGradient(touches, 0.02, g);
    Points3 slopes(X.rows(), 3);
    constexpr double kStep = 1e-6;
    for (Eigen::Index i = 0; i < X.size(); ++i) {
        Points3 more = X, less = X;
        more.data()[i] += kStep;
        less.data()[i] -= kStep;
        slopes.data()[i] = (contact.energy(contact.touchesAt(more, 1), 0.02) -
                            contact.energy(contact.touchesAt(less, 1), 0.02)) /
                           (2 * kStep);
    }
    EXPECT_NEAR((g - slopes).norm(), 0, 1e-6 * g.norm());
    EXPECT_NEAR(g.colwise().sum().norm(), 0, 1e-12 * g.norm());  // it cannot push itself along
}

TEST(SelfContact, LeavesAloneWhatBelongsTogether) {
    const Cloth tube = sewTogether(test::tubeCloth(24, 12, 8, 25));  // edges of 2 mm
    const SelfContact ofTube(tube, 3, 1);
    EXPECT_TRUE(ofTube.touchesAt(tube.X, 3).empty());
    const CutCloth facing = twoSheets(4, 4, 10, {0, 0, 0});
    const Cloth faced = sewTogether(facing);
    const SelfContact ofFacing(faced, 1, 1);
    EXPECT_TRUE(ofFacing.touchesAt(faced.X, 1).empty());
    Points3 slid = faced.X;  // as far as its triangles are large
    slid.bottomRows(slid.rows() / 2).rowwise() += Eigen::RowVector3d(7, 3, 0.2);
    EXPECT_TRUE(ofFacing.touchesAt(slid, 1).empty());
}

TEST(SelfContact, AStepEndsBeforeClothMeetsCloth) {
    const Cloth cloth = sewTogether(twoSheets(3, 3, 10, {1, 2, 6}));
    const SelfContact contact(cloth, 1, 1);
    const Eigen::Index half = cloth.X.rows() / 2;
    Points3 step = Points3::Zero(cloth.X.rows(), 3);
    step.bottomRows(half).col(2).array() = -12;  // 6 mm too far
    const double way = contact.freeWay(cloth.X, step);
    EXPECT_LT(12 * way, 5.4 + 1e-9);
    EXPECT_GT(12 * way, 5);
    step.bottomRows(half).col(2).array() = -5;
    EXPECT_EQ(contact.freeWay(cloth.X, step), 1);
    step.bottomRows(half).col(2).array() = -5.9995;  // not quite there
    EXPECT_LT(5.9995 * contact.freeWay(cloth.X, step), 5.4 + 1e-9);
    step.rowwise() = Eigen::RowVector3d(40, 20, -300);  // all of it
    EXPECT_EQ(contact.freeWay(cloth.X, step), 1);
    step.setZero();
    step.bottomRows(half).col(0).array() = 80;  // beside it
    EXPECT_EQ(contact.freeWay(cloth.X, step), 1);
}

TEST(SelfContact, AsManyThreadsTheSameTouchesAndWays) {
    const Cloth cloth = sewTogether(twoSheets(30, 30, 4, {1, 0.5, 3}));
    Points3 X = test::shaken(cloth.X, 0.4, 9);
    X.bottomRows(X.rows() / 2).col(2).array() -= 2.2;
    const Points3 step = test::shaken(Points3::Zero(X.rows(), 3), 2, 5);
    const SelfContact one(cloth, 1, 1), three(cloth, 1, 3);
    Points3 g = Points3::Zero(X.rows(), 3), h = g;
    one.addGradient(one.touchesAt(X, 1), 0.02, g);
    three.addGradient(three.touchesAt(X, 1), 0.02, h);
    EXPECT_GT(g.norm(), 0);
    EXPECT_TRUE((g.array() == h.array()).all());
    EXPECT_LT(one.freeWay(X, step), 1);
    EXPECT_EQ(one.freeWay(X, step), three.freeWay(X, step));
}

TEST(SelfContact, APageFallsOnTheOtherAndRestsAtTheThickness) {
    const Cloth cloth = sewTogether(openBook(6, 12, 1.2));
    const WornSurface surface = table();
    SettleOptions options = fallingCloth();
    const auto settled = settle(cloth, cloth.X, surface, options, {});
    ASSERT_TRUE(settled);
    EXPECT_TRUE(settled->hasSettled);
    // The second page's vertices follow the first's; its first row stands up from the seam.
    const auto heights = [](const Points3& X) { return X.col(1).tail(X.rows() - 56); };
    EXPECT_LT(settled->X.col(1).head(49).cwiseAbs().maxCoeff(), 0.01);
    EXPECT_NEAR(heights(settled->X).minCoeff(), options.thickness, 0.01);
    EXPECT_NEAR(heights(settled->X).maxCoeff(), options.thickness, 0.01);
    options.touchesItself = false;
    const auto through = settle(cloth, cloth.X, surface, options, {});
    ASSERT_TRUE(through);
    EXPECT_LT(heights(through->X).maxCoeff(), 0.1);
}

TEST(SelfContact, ATubeThatIsPressedFlatDoesNotGoThroughItself) {
    CutCloth cut = test::tubeCloth(20, 8, 20, 80);
    for (Eigen::Index v = 0; v < cut.V.rows(); ++v) {  // it lies
        cut.V.row(v) = Eigen::RowVector3d(cut.V(v, 0), cut.V(v, 2) + 21, cut.V(v, 1)).eval();
    }
    for (Eigen::Index f = 0; f < cut.F.rows(); ++f) {
        std::swap(cut.F(f, 1), cut.F(f, 2));
    }
    const Cloth cloth = sewTogether(cut);
    const WornSurface surface = table();
    SettleOptions options = fallingCloth();
    options.gravity = 0;
    options.pressure = 2e-5;
    const auto settled = settle(cloth, cloth.X, surface, options, {});
    ASSERT_TRUE(settled);
    EXPECT_TRUE(settled->hasSettled);
    const SelfContact contact(cloth, 1, 1);
    for (const auto& touch : contact.touchesAt(settled->X, 1)) {
        EXPECT_GT(touch.distance, 0.9);
    }
    // What was above is above.
    double tallest = 0;
    for (Eigen::Index v = 0; v < cloth.X.rows(); ++v) {
        tallest = std::max(tallest, settled->X(v, 1));
        for (Eigen::Index w = 0; w < cloth.X.rows(); ++w) {
            const bool isBelow = cloth.X(v, 1) > 25 && cloth.X(w, 1) < 17;
            const Eigen::RowVector3d apart = settled->X.row(v) - settled->X.row(w);
            if (isBelow && std::hypot(apart.x(), apart.z()) < 3) {
                EXPECT_GT(apart.y(), 0) << v << " " << w;
            }
        }
    }
    EXPECT_LT(tallest, 15);
}

TEST(SelfContact, WhereClothIsFarFromItselfNothingChanges) {
    CutCloth cut = test::tubeCloth(24, 6, 60, 90);
    const WornSurface surface(sewTogether(cut).surface());
    cut.Q *= 1.01;
    const Cloth cloth = sewTogether(cut);
    SettleOptions options;
    const auto without = settle(cloth, cloth.X, surface, options, {});
    options.touchesItself = true;
    const auto with = settle(cloth, cloth.X, surface, options, {});
    ASSERT_TRUE(without && with);
    EXPECT_TRUE((with->X.array() == without->X.array()).all());
}

TEST(SelfContact, AFacingStaysOnItsPiece) {
    CutCloth cut = twoSheets(6, 6, 10, {0, 0, 0});
    for (int i = 0; i <= 6; ++i) {
        cut.sewn.emplace_back(7 * i, 49 + 7 * i);
    }
    const WornSurface surface(sewTogether(test::flatCloth(6, 6, 10)).surface());
    cut.Q.bottomRows(49) *= 1.01;
    const Cloth cloth = sewTogether(cut);
    SettleOptions options;
    const auto without = settle(cloth, cloth.X, surface, options, {});
    options.touchesItself = true;
    const auto with = settle(cloth, cloth.X, surface, options, {});
    ASSERT_TRUE(without && with);
    EXPECT_TRUE(with->hasSettled);
    EXPECT_LT((with->X - without->X).rowwise().norm().maxCoeff(), 1e-9);
}

TEST(SelfContact, NoStepRaisesTheEnergy) {
    const Cloth cloth = sewTogether(openBook(4, 12, 0.8));
    const WornSurface surface = table();
    SettleOptions options = fallingCloth();
    options.heldFirst = false;
    std::vector<Points3> way;
    options.watch = [&](const Points3& X) { way.push_back(X); };
    ASSERT_TRUE(settle(cloth, cloth.X, surface, options, {}));
    ClothForces forces(cloth, surface, options);
    forces.hold({0, 0.3, 0});
    std::vector<double> soft;
    for (const Points3& X : way) {
        soft.push_back(forces.at(X).energy);
    }
    forces.hold({0, 1, 0});
    std::size_t rises = 0, hard = 0;
    double before = forces.at(way.front()).energy;
    for (std::size_t k = 1; k < way.size(); ++k) {
        const double now = forces.at(way[k]).energy;
        rises += soft[k] > soft[k - 1] + 1e-12 * std::abs(soft[k - 1]) && now > before + 1e-9;
        hard += now < before;
        before = now;
    }
    EXPECT_EQ(rises, 0U);  // over the soft table and cloth, and from there on over the hard ones
    EXPECT_GT(hard, 0U);
}

TEST(SelfContact, ForcesAreTheEnergysDerivatives) {
    const Cloth cloth = sewTogether(openBook(3, 10, 0.6));
    const WornSurface surface = table();
    SettleOptions options = fallingCloth();
    ClothForces forces(cloth, surface, options);
    forces.hold({0, 1, 0});
    Points3 X = cloth.X;
    X.col(1) *= 0.06;
    X = test::shaken(X, 0.2, 4);
    const Points3 g = forces.gradient(forces.at(X));
    Points3 slopes(X.rows(), 3);
    constexpr double kStep = 1e-6;
    for (Eigen::Index i = 0; i < X.size(); ++i) {
        Points3 more = X, less = X;
        more.data()[i] += kStep;
        less.data()[i] -= kStep;
        slopes.data()[i] = (forces.at(more).energy - forces.at(less).energy) / (2 * kStep);
    }
    EXPECT_FALSE(forces.at(X).touches.empty());
    EXPECT_NEAR((g - slopes).norm(), 0, 1e-4 * g.norm());
}

}  // namespace
}  // namespace toile::sew
