// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "core/quality/piece_quality.h"

namespace toile {
namespace {

Points2 flag() {
    Points2 points(4, 2);
    points << 0, 0, 40, 0, 40, 10, 0, 30;
    return points;
}

TEST(ReferenceFit, IgnoresRigidMotionsAndReflections) {
    Eigen::Matrix2d turn;
    turn << std::cos(2.0), std::sin(2.0), -std::sin(2.0), std::cos(2.0);
    const Points2 moved = (flag() * turn).rowwise() + Eigen::RowVector2d(300, -20);
    const ReferenceFit rigid = fitToReference(moved, flag());
    EXPECT_LT(rigid.max, 1e-12 * 300);
    EXPECT_FALSE(rigid.mirrored);
    Points2 mirrored = moved;
    mirrored.col(0) *= -1;
    const ReferenceFit reflected = fitToReference(mirrored, flag());
    EXPECT_LT(reflected.max, 1e-12 * 300);
    EXPECT_TRUE(reflected.mirrored);
}

TEST(ReferenceFit, MeasuresWhatIsLeft) {
    Points2 stretched = flag();
    stretched.col(0) *= 1.1;
    const ReferenceFit fit = fitToReference(stretched, flag());
    EXPECT_GT(fit.rms, 1);
    EXPECT_LT(fit.rms, 2.1);  // at most half of the 4 mm, on either side
    EXPECT_GE(fit.max, fit.rms);
}

TEST(ReferenceFit, PlacesThePanelOnThePiece) {
    Eigen::Matrix2d turn;
    turn << std::cos(2.0), std::sin(2.0), -std::sin(2.0), std::cos(2.0);
    for (const double mirror : {1.0, -1.0}) {
        Points2 panel = (flag() * turn).rowwise() + Eigen::RowVector2d(300, -20);
        panel.col(1) *= mirror;
        EXPECT_LT((placedReference(flag(), panel) - flag()).cwiseAbs().maxCoeff(), 1e-10);
    }
    // Where the two differ, the distances left are those of the fit.
    Points2 stretched = flag();
    stretched.col(0) *= 1.1;
    const Eigen::VectorXd left = (placedReference(flag(), stretched) - flag()).rowwise().norm();
    EXPECT_NEAR(left.maxCoeff(), fitToReference(flag(), stretched).max, 1e-12);
}

}  // namespace
}  // namespace toile
