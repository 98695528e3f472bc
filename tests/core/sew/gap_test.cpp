// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/gap.h"

#include <gtest/gtest.h>

#include "tests/core/sew/cloth_shapes.h"

namespace toile::sew {
namespace {

TEST(Gap, OfLiftedClothIsItsHeight) {
    const Cloth cloth = sewTogether(test::flatCloth(4, 4, 10));
    const WornSurface plane(cloth.surface());
    Points3 X = cloth.X;
    X.col(2).array() -= 3;
    const SpreadFigures gap = gapTo(plane, cloth, X);
    EXPECT_NEAR(gap.mean, 3, 1e-12);
    EXPECT_NEAR(gap.most95, 3, 1e-12);
    EXPECT_NEAR(gap.max, 3, 1e-12);
}

TEST(Gap, NamesThePlaceOfTheLargest) {
    const Cloth cloth = sewTogether(test::flatCloth(10, 10, 10));
    const WornSurface plane(cloth.surface());
    Points3 X = cloth.X;
    const int lifted = 5 * 11 + 5;
    X(lifted, 2) = 6;
    const SpreadFigures gap = gapTo(plane, cloth, X);
    EXPECT_NEAR(gap.max, 6, 1e-12);
    EXPECT_LT(gap.most95, 3);
    EXPECT_TRUE((cloth.F.row(gap.place).array() == lifted).any());
    EXPECT_NEAR(gap.mean, 6.0 * 100 / 10000, 1e-9);  // a hat function over six half squares
}

TEST(Gap, PastARimIsTheDistanceFromTheRim) {
    const Cloth cloth = sewTogether(test::flatCloth(2, 2, 10));
    const WornSurface plane(cloth.surface());
    Points3 X = cloth.X;
    X.col(0).array() += 20;
    EXPECT_NEAR(gapTo(plane, cloth, X).max, 20, 1e-12);
}

TEST(Gap, OfPiecesIsEachOnesOwn) {
    CutCloth cut = test::flatCloth(4, 4, 10);
    for (std::size_t f = 0; f < cut.pieceOf.size(); ++f) {
        cut.pieceOf[f] = cut.V(cut.F(static_cast<Eigen::Index>(f), 0), 1) < 20 ? 0 : 1;
    }
    const Cloth cloth = sewTogether(cut);
    const WornSurface plane(cloth.surface());
    Points3 X = cloth.X;
    for (Eigen::Index v = 0; v < X.rows(); ++v) {
        X(v, 2) = cloth.X(v, 1) > 25 ? 4 : 0;
    }
    const ClothGaps gaps = gapsTo(plane, cloth, X);
    ASSERT_EQ(gaps.pieces.size(), 2U);
    EXPECT_NEAR(gaps.whole.mean, gapTo(plane, cloth, X).mean, 0);
    EXPECT_NEAR(gaps.whole.mean, (gaps.pieces[0].mean + gaps.pieces[1].mean) / 2, 1e-9);
    EXPECT_LT(gaps.pieces[0].mean, 0.1);
    EXPECT_GT(gaps.pieces[1].mean, 1);
}

TEST(Gap, StrainIsTheLargerOfTwo) {
    const Cloth cloth = sewTogether(test::flatCloth(2, 2, 10));
    Points3 X = cloth.X;
    X.col(0) *= 1.02;
    X.col(1) *= 0.95;
    const SpreadFigures strain = strainOf(cloth, X);
    EXPECT_NEAR(strain.mean, 0.05, 1e-12);
    EXPECT_NEAR(strain.max, 0.05, 1e-12);
    EXPECT_NEAR(strainOf(cloth, cloth.X).max, 0, 1e-12);
}

}  // namespace
}  // namespace toile::sew
