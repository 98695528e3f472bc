// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/settle.h"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/sew/gap.h"
#include "tests/core/sew/cloth_shapes.h"

namespace toile::sew {
namespace {

/// Without bending, and so that cloth rests 1e-7 mm outside where nothing else pulls.
SettleOptions exactOptions() {
    SettleOptions options;
    options.stiffness.bending = 0;
    options.pressure = 1e-7;
    options.contactStiffness = 1;
    options.share = 1e-4;
    options.maxIterations = 600;
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
    EXPECT_LT(gapOfShort.mean, 0.02);  // it is strained instead
    EXPECT_GT(gapOfLong.mean, 3 * gapOfRight.mean);
    EXPECT_GT(gapOfLong.mean, 0.1);
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
}

}  // namespace
}  // namespace toile::sew
