// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/seam_measure.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/seam/find_seams.h"
#include "tests/core/seam/seam_shapes.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using test::asPiece;
using test::named;
using test::rectangle;

FlatPiece flat(const Piece& piece, double stretchAlong = 1) {
    FlatPiece made;
    made.Q = piece.mesh.V.leftCols(2);
    made.Q.col(1) *= stretchAlong;
    return made;
}

TEST(SeamMeasure, ExactSidesHaveNoDifference) {
    const auto l = asPiece(rectangle(0, 0, 50, 100, 5, 10), "front");
    const auto r = asPiece(rectangle(50.1, 0, 70, 100, 7, 13), "back");
    const Seam seam = named(findSeams({l, r}), "front / back");
    const SeamMeasure m = measureSeam(seam, *l, flat(*l), *r, flat(*r));
    EXPECT_NEAR(m.length2dLeft, 100, 1e-9);
    EXPECT_NEAR(m.length2dRight, 100, 1e-9);
    EXPECT_NEAR(m.deltaMm, 0, 1e-9);
    EXPECT_NEAR(m.errorMm, 0, 1e-9);
    EXPECT_NEAR(m.ease, 0, 1e-12);
}

TEST(SeamMeasure, WhatFlatteningAddsIsAnErrorAndEaseIsNot) {
    const auto l = asPiece(rectangle(0, 0, 50, 100, 5, 10), "front");
    const auto r = asPiece(rectangle(50, 0, 70, 100, 7, 10), "back");
    const Seam seam = named(findSeams({l, r}), "front / back");
    const SeamMeasure wrong = measureSeam(seam, *l, flat(*l, 1.1), *r, flat(*r));
    EXPECT_NEAR(wrong.deltaMm, 10, 1e-9);
    EXPECT_NEAR(wrong.errorMm, 10, 1e-9);
    Seam meant = seam;
    meant.ease = 0.1;
    const SeamMeasure eased = measureSeam(meant, *l, flat(*l, 1.1), *r, flat(*r));
    EXPECT_NEAR(eased.deltaMm, 10, 1e-9);
    EXPECT_NEAR(eased.errorMm, 0, 1e-9);
    EXPECT_NEAR(eased.ease, 0.1, 1e-12);
}

TEST(SeamMeasure, PartsOfEdgesCountInProportion) {
    // The back ends within an edge of the front, 95 mm up; the front's flat edges are doubled.
    const auto l = asPiece(rectangle(0, 0, 50, 140, 5, 14), "front");
    const auto r = asPiece(rectangle(50, 0, 70, 95, 7, 9), "back");
    const Seam seam = named(findSeams({l, r}), "front / back");
    EXPECT_EQ(seam.left.count, 10);
    const SeamMeasure m = measureSeam(seam, *l, flat(*l, 2), *r, flat(*r));
    EXPECT_NEAR(m.length3d[0], 95, 1e-9);
    EXPECT_NEAR(m.length2dLeft, 190, 1e-9);
    EXPECT_NEAR(m.length2dRight, 95, 1e-9);
}

TEST(SeamMeasure, AFreeEdgeHasALengthAndNoDifference) {
    const auto piece = asPiece(rectangle(0, 0, 50, 100, 5, 10), "front");
    const Seam edge = named(findSeams({piece}), "front, free edge");
    const SeamMeasure m = measureSeam(edge, *piece, flat(*piece), *piece, {});
    EXPECT_NEAR(m.length2dLeft, 300, 1e-9);
    EXPECT_EQ(m.deltaMm, 0);
    EXPECT_EQ(m.errorMm, 0);
}

TEST(SeamMeasure, LinesInSpaceAreAsLongAsTheSidesAndRunTogether) {
    const auto l = asPiece(rectangle(0, 0, 50, 140, 5, 14), "front");
    const auto r = asPiece(rectangle(50, 0, 70, 95, 7, 9), "back");
    const Seam seam = named(findSeams({l, r}), "front / back");
    const auto length = [](const Points3& line) {
        const Eigen::Index n = line.rows() - 1;
        return (line.bottomRows(n) - line.topRows(n)).rowwise().norm().sum();
    };
    const Points3 left = spaceLine(seam.left, *l), right = spaceLine(seam.right, *r);
    EXPECT_NEAR(length(left), 95, 1e-9);
    EXPECT_NEAR(length(right), 95, 1e-9);
    EXPECT_LT((left.topRows<1>() - right.topRows<1>()).norm(), 1e-9);
    EXPECT_LT((left.bottomRows<1>() - right.bottomRows<1>()).norm(), 1e-9);
    EXPECT_EQ(left.rows(), flatLine(seam.left, *l, flat(*l)).rows());
}

TEST(SeamMeasure, PlacesComeToLieOnEachOther) {
    const auto l = asPiece(rectangle(0, 0, 50, 140, 5, 14), "front");
    const auto r = asPiece(rectangle(50, 0, 70, 95, 7, 9), "back");
    const Seam seam = named(findSeams({l, r}), "front / back");
    for (const double share : {0.0, 0.013, 0.5, 0.77, 1.0}) {
        const double left = std::lerp(seam.left.start, seam.left.end, share);
        const double right = placeAcross(seam, left, false);
        EXPECT_NEAR(right, std::lerp(seam.right.start, seam.right.end, share), 1e-9) << share;
        EXPECT_NEAR(placeAcross(seam, right, true), left, 1e-9) << share;
    }
    const bool rises = seam.left.start < seam.left.end;
    EXPECT_NEAR(placeAcross(seam, seam.left.start + (rises ? -5 : 5), false), seam.right.start,
                1e-9);
    EXPECT_NEAR(placeAcross(seam, seam.left.end + (rises ? 5 : -5), false), seam.right.end, 1e-9);
}

}  // namespace
}  // namespace toile
