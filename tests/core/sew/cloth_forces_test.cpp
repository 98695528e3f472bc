// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/cloth_forces.h"

#include <gtest/gtest.h>

#include "tests/core/sew/cloth_shapes.h"

namespace toile::sew {
namespace {

TEST(ClothForces, AreTheEnergysDerivativesWhateverActs) {
    const Cloth cloth = sewTogether(test::tubeCloth(7, 2, 30, 40));
    const WornSurface surface(cloth.surface());
    SettleOptions options;
    options.gravity = 9.81;
    for (const double pressure : {1e-3, 0.0, -1e-3}) {
        options.pressure = pressure;
        ClothForces forces(cloth, surface, options);
        for (const ClothHold& hold :
             {ClothHold{0, 1, 0}, ClothHold{1e-3, 0.1, 0}, ClothHold{1, 0, 0}}) {
            forces.hold(hold);
            const Points3 X = test::shaken(cloth.X, 2, 5);
            const Points3 g = forces.gradient(forces.at(X));
            constexpr double kStep = 1e-5;
            Points3 slopes(X.rows(), 3);
            for (Eigen::Index i = 0; i < X.size(); ++i) {
                Points3 more = X, less = X;
                more.data()[i] += kStep;
                less.data()[i] -= kStep;
                slopes.data()[i] = (forces.at(more).energy - forces.at(less).energy) / (2 * kStep);
            }
            EXPECT_NEAR((g - slopes).norm(), 0, 1e-5 * g.norm()) << pressure << " " << hold.pin;
        }
    }
}

TEST(ClothForces, PiecesAreAsStiffAndHeavyAsIsStated) {
    const Cloth cloth = sewTogether(test::cubeCloth(1, 10));
    SettleOptions options;
    options.gravity = 10;
    options.pressure = 0;
    options.stiffness = {kUnstatedStiffness, kUnstatedStiffness};
    options.stiffness[0].weight = 1150;
    const WornSurface surface(cloth.surface());
    ClothForces forces(cloth, surface, options);
    forces.hold({0, 0, 0});
    const Points3 g = forces.gradient(forces.at(cloth.X));
    EXPECT_NEAR(g.col(1).sum(), (1150 + 5 * 150) * 1e-9 * 10 * 100, 1e-12);
}

}  // namespace
}  // namespace toile::sew
