// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/settle.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/sew/cloth_forces.h"
#include "core/sew/gap.h"
#include "tests/core/sew/cloth_shapes.h"

namespace toile::sew {
namespace {

/// Without bending, and so that cloth rests 1e-7 mm outside where nothing else pulls.
SettleOptions exactOptions() {
    SettleOptions options;
    options.stiffness.assign(6, isotropicStiffness(1000, 0.3, 0));
    options.pressure = 1e-7;
    options.contactStiffness = 1;
    options.share = 1e-4;
    options.maxIterations = 600;
    options.heldFirst = false;
    return options;
}

struct ExactShape {
    const char* name;
    CutCloth cut;
    MeshArrays form;
    bool isRound;  ///< around the y axis
};

std::vector<ExactShape> exactShapes() {
    std::vector<ExactShape> shapes;
    const auto add = [&](const char* name, const CutCloth& cut, bool isRound) {
        shapes.push_back({name, cut, sewTogether(cut).surface(), isRound});
    };
    add("tube", test::tubeCloth(12, 4, 60, 90), true);
    add("cone", test::coneCloth(12, 4, 60, 160, 0.4), true);
    add("cube", test::cubeCloth(4, 100), false);
    // Nothing holds cloth along a tube: its form goes on past both hems.
    shapes[0].form = sewTogether(test::tubeCloth(12, 6, 60, 135)).surface();
    shapes[0].form.V.col(1).array() -= 22.5;
    return shapes;
}

/// Away from the y axis, or from the origin.
Points3 blownUp(const Points3& X, double factor, bool aroundAxis) {
    Points3 moved = factor * X;
    if (aroundAxis) {
        moved.col(1) = X.col(1);
    }
    return moved;
}

TEST(Settle, UnstrainedClothSewsBackOntoItsForm) {
    for (const ExactShape& shape : exactShapes()) {
        const Cloth cloth = sewTogether(shape.cut);
        const WornSurface surface(shape.form);
        const Points3 start = blownUp(cloth.X, 1.1, shape.isRound);
        const auto settled = settle(cloth, start, surface, exactOptions(), {});
        ASSERT_TRUE(settled) << shape.name;
        EXPECT_TRUE(settled->hasSettled) << shape.name;
        EXPECT_LT(gapTo(surface, cloth, settled->X).max, 1e-6) << shape.name;
        EXPECT_LT(strainOf(cloth, settled->X).max, 1e-7) << shape.name;
    }
}

TEST(Settle, ClothOverSharpEdgesSettlesAsClothDoes) {
    const Cloth cloth = sewTogether(test::cubeCloth(4, 100));
    const WornSurface surface(cloth.surface());
    for (const double factor : {0.9, 1.0, 1.1}) {
        const auto settled = settle(cloth, factor * cloth.X, surface, {}, {});
        ASSERT_TRUE(settled);
        EXPECT_TRUE(settled->hasSettled) << factor;
        EXPECT_LT(gapTo(surface, cloth, settled->X).max, 1e-3) << factor;
    }
}

TEST(Settle, ClothThatIsTooShortIsStrainedAndTooLongHasAGap) {
    CutCloth cut = test::tubeCloth(72, 8, 60, 90);  // vertices alone are held off the edges
    const WornSurface surface(sewTogether(cut).surface());
    const Points2 right = cut.Q;
    const auto sewn = [&](double scale) {
        cut.Q = right;
        cut.Q.col(0) *= scale;
        const Cloth cloth = sewTogether(cut);
        const auto settled = settle(cloth, cloth.X, surface, {}, {});
        EXPECT_TRUE(settled && settled->hasSettled) << scale;
        return std::pair{gapTo(surface, cloth, settled->X), strainOf(cloth, settled->X)};
    };
    const auto [gapOfRight, strainOfRight] = sewn(1);
    const auto [gapOfShort, strainOfShort] = sewn(0.98);
    const auto [gapOfLong, strainOfLong] = sewn(1.02);
    EXPECT_NEAR(strainOfShort.mean, 1 / 0.98 - 1, 2e-3);
    EXPECT_LT(strainOfRight.mean, 1e-4);
    EXPECT_LT(gapOfRight.mean, 0.01);
    EXPECT_LT(gapOfShort.mean, 0.1);  // it is strained instead; its edges cut corners
    EXPECT_GT(gapOfLong.mean, 3 * gapOfRight.mean);
    EXPECT_GT(gapOfLong.mean, 0.1);
}

TEST(Settle, EndsInTheSamePlaceFromTheFormAndFromOnePushedOff) {
    CutCloth cut = test::tubeCloth(24, 6, 60, 90);
    const WornSurface surface(sewTogether(cut).surface());
    cut.Q *= 1.03;
    const Cloth cloth = sewTogether(cut);
    const auto fromForm = settle(cloth, cloth.X, surface, {}, {});
    const auto fromOff = settle(cloth, blownUp(cloth.X, 70.0 / 60, true), surface, {}, {});
    ASSERT_TRUE(fromForm && fromOff);
    EXPECT_TRUE(fromForm->hasSettled && fromOff->hasSettled);
    EXPECT_LT((fromForm->X - fromOff->X).rowwise().norm().mean(), 0.05);
    EXPECT_GT(gapTo(surface, cloth, fromForm->X).max, 0.5);
}

TEST(Settle, NoStepRaisesTheEnergy) {
    CutCloth cut = test::tubeCloth(24, 6, 60, 90);
    const WornSurface surface(sewTogether(cut).surface());
    cut.Q *= 1.03;
    const Cloth cloth = sewTogether(cut);
    std::vector<Points3> way;
    SettleOptions options;
    options.heldFirst = false;
    options.watch = [&](const Points3& X) { way.push_back(X); };
    ASSERT_TRUE(settle(cloth, blownUp(cloth.X, 1.1, true), surface, options, {}));
    ASSERT_GT(way.size(), 5);
    const auto energiesOn = [&](double contact) {
        ClothForces forces(cloth, surface, options);
        forces.hold({0, contact, 0});
        std::vector<double> energies;
        for (const Points3& X : way) {
            energies.push_back(forces.at(X).energy);
        }
        return energies;
    };
    const auto rises = [](double before, double now) { return now > before * (1 + 1e-12); };
    // Over the soft surface as long as that lasts, and from there on over the hard one.
    const std::vector<double> soft = energiesOn(0.3), hard = energiesOn(1);
    const auto turn = std::ranges::adjacent_find(soft, rises) - soft.begin();
    EXPECT_EQ(std::adjacent_find(hard.begin() + std::min<std::ptrdiff_t>(turn + 1, way.size()),
                                 hard.end(), rises),
              hard.end());
}

TEST(Settle, NoClothAndNoStartAreErrors) {
    const Cloth cloth = sewTogether(test::flatCloth(2, 2, 10));
    const WornSurface surface(cloth.surface());
    const auto none = settle(Cloth{}, Points3(0, 3), surface, {}, {});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::NoGeometry);
    Points3 lost = cloth.X;
    lost(3, 1) = std::nan("");
    const auto nowhere = settle(cloth, lost, surface, {}, {});
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().code, ErrorCode::NotFinite);
}

TEST(Settle, ClothThatTouchesNothingFindsItsOwnForm) {
    const Cloth cloth = sewTogether(test::flatCloth(6, 3, 10));
    const WornSurface far(sewTogether(test::cubeCloth(1, 10)).surface());
    SettleOptions options;
    options.pressure = 0;
    options.heldFirst = false;
    Points3 start = test::shaken(cloth.X, 0.5, 3);
    start.rowwise() += Eigen::RowVector3d(500, 0, 0);
    const auto settled = settle(cloth, start, far, options, {});
    ASSERT_TRUE(settled);
    EXPECT_TRUE(settled->hasSettled);
    EXPECT_LT(strainOf(cloth, settled->X).max, 1e-3);
}

/// Flat cloth in a plane across from which gravity pulls.
Cloth levelCloth(int squares, double size) {
    CutCloth cut = test::flatCloth(squares, squares, size);
    const double middle = squares * size / 2;
    for (Eigen::Index v = 0; v < cut.V.rows(); ++v) {
        cut.V.row(v) << cut.Q(v, 1) - middle, 0, cut.Q(v, 0) - middle;
    }
    return sewTogether(cut);
}

TEST(Settle, ClothOnATableLiesAsDeepAsItsWeightPressesIt) {
    const Cloth cloth = levelCloth(4, 10);
    const WornSurface table(cloth.surface());
    SettleOptions options;
    options.pressure = 0;
    options.gravity = 9.81;
    options.stiffness = {kUnstatedStiffness};
    options.stiffness[0].weight = 300;
    options.share = 1e-6;
    const auto settled = settle(cloth, cloth.X, table, options, {});
    ASSERT_TRUE(settled);
    EXPECT_TRUE(settled->hasSettled);
    const double deep = 300 * 9.81 * 1e-9 / options.contactStiffness;
    EXPECT_NEAR((settled->X.col(1).array() - deep).abs().maxCoeff(), 0, 1e-3 * deep);
}

TEST(Settle, ASheetUnderGravityDoesNotFallThroughABody) {
    Cloth cloth = levelCloth(10, 16);
    cloth.X.col(1).array() += 51;
    const WornSurface cube(sewTogether(test::cubeCloth(4, 100)).surface());
    SettleOptions options;
    options.pressure = 0;
    options.gravity = 9.81;
    options.stiffness = {isotropicStiffness(300, 0.3, 2e-5)};
    options.maxIterations = 400;
    const auto settled = settle(cloth, cloth.X, cube, options, {});
    ASSERT_TRUE(settled);
    EXPECT_TRUE(settled->hasSettled);
    double least = 0;
    for (Eigen::Index v = 0; v < settled->X.rows(); ++v) {
        least = std::min(least, cube.placeOf(settled->X.row(v).transpose()).distance);
    }
    EXPECT_GT(least, -0.05);
    EXPECT_LT(settled->X.col(1).minCoeff(), 40);  // the rim hangs
}

TEST(Settle, ClothThatNothingHoldsIsLetFallNoFarther) {
    const Cloth cloth = sewTogether(test::flatCloth(4, 4, 50));  // upright
    const WornSurface surface(cloth.surface());
    SettleOptions options = exactOptions();
    options.pressure = 0;
    options.gravity = 9.81;
    options.heldFirst = true;
    const auto settled = settle(cloth, cloth.X, surface, options, {});
    ASSERT_TRUE(settled);
    EXPECT_FALSE(settled->hasSettled);
    EXPECT_LT(settled->iterations, 100);
    EXPECT_TRUE(settled->X.allFinite());
    EXPECT_LT(settled->X.col(1).maxCoeff(), cloth.X.col(1).minCoeff() - 2000);
}

TEST(Settle, PressureOutwardsFillsACushion) {
    const Cloth cloth = sewTogether(test::cubeCloth(6, 100));
    const WornSurface surface(cloth.surface());
    SettleOptions options;
    options.pressure = -1e-3;
    const auto settled = settle(cloth, cloth.X, surface, options, {});
    ASSERT_TRUE(settled);
    EXPECT_TRUE(settled->hasSettled);
    EXPECT_GT(gapTo(surface, cloth, settled->X).max, 5);
    EXPECT_GT(settled->X.col(0).maxCoeff(), 55);
    EXPECT_GT(settled->X.col(1).maxCoeff(), 55);
}

TEST(Settle, AsManyThreadsTheSameBytes) {
    const Cloth cloth = sewTogether(test::cubeCloth(16, 100));
    const WornSurface surface(cloth.surface());
    SettleOptions options;
    options.maxIterations = 12;
    const auto one = settle(cloth, 1.05 * cloth.X, surface, options, {});
    options.threads = 3;
    const auto three = settle(cloth, 1.05 * cloth.X, surface, options, {});
    ASSERT_TRUE(one && three);
    EXPECT_TRUE((one->X.array() == three->X.array()).all());
}

TEST(Settle, SameInputSameBytes) {
    const Cloth cloth = sewTogether(test::coneCloth(10, 3, 60, 160, 0.4));
    const WornSurface surface(cloth.surface());
    const Points3 start = test::shaken(1.05 * cloth.X, 2, 4);
    const auto first = settle(cloth, start, surface, {}, {});
    const auto second = settle(cloth, start, surface, {}, {});
    ASSERT_TRUE(first && second);
    EXPECT_TRUE((first->X.array() == second->X.array()).all());
    EXPECT_TRUE(first->hasSettled);
    EXPECT_LE(first->restForce, SettleOptions{}.share * first->seamForce);
}

TEST(Settle, ReportsAndCanBeCancelled) {
    const Cloth cloth = sewTogether(test::tubeCloth(12, 4, 60, 90));
    const WornSurface surface(cloth.surface());
    Progress progress;
    int steps = 0;
    SettleOptions options;
    options.watch = [&](const Points3& X) {
        EXPECT_EQ(X.rows(), cloth.X.rows());
        if (++steps == 2) {
            progress.cancel();
        }
    };
    const auto settled = settle(cloth, blownUp(cloth.X, 1.1, true), surface, options, progress);
    ASSERT_FALSE(settled);
    EXPECT_EQ(settled.error().code, ErrorCode::Cancelled);
    EXPECT_EQ(steps, 2);
    EXPECT_GT(progress.fraction(), 0);
    options.touchesItself = true;  // what belongs together is looked for before the first step
    const auto none = settle(cloth, cloth.X, surface, options, progress);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::Cancelled);
    EXPECT_EQ(steps, 2);
}

}  // namespace
}  // namespace toile::sew
