// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/io/conventions.h"

namespace toile {
namespace {

TEST(UpAxis, IsYUnlessTheGarmentIsFlattestAlongIt) {
    EXPECT_EQ(guessUpAxis({790, 677, 287}).axis, UpAxis::Y);  // a T-shirt
    EXPECT_EQ(guessUpAxis({884, 326, 602}).axis, UpAxis::Y);  // perhaps one that lies: in doubt
    EXPECT_TRUE(guessUpAxis({884, 326, 602}).inDoubt);
    EXPECT_EQ(guessUpAxis({480, 300, 1070}).axis, UpAxis::Z);  // trousers
    EXPECT_FALSE(guessUpAxis({480, 300, 1070}).inDoubt);
    EXPECT_EQ(guessUpAxis({1200, 300, 1200}).axis, UpAxis::Y);  // a wide skirt
    EXPECT_FALSE(guessUpAxis({1200, 300, 1200}).inDoubt);
    EXPECT_EQ(guessUpAxis({0, 0, 0}).axis, UpAxis::Y);
}

TEST(UpAxis, TurnsThereAndBackExactly) {
    const Eigen::RowVector3d p(0.1, 0.2, 0.3);
    for (const UpAxis axis : {UpAxis::Y, UpAxis::Z}) {
        EXPECT_EQ(asInFile(axis, withYUp(axis, p)), p);
        EXPECT_EQ(parseUpAxis(name(axis)), axis);
    }
    EXPECT_EQ(withYUp(UpAxis::Z, p), Eigen::RowVector3d(0.1, 0.3, -0.2));
    EXPECT_FALSE(parseUpAxis("x"));
}

}  // namespace
}  // namespace toile
