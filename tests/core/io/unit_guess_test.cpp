// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <gtest/gtest.h>

#include "core/io/conventions.h"

namespace toile {
namespace {

TEST(UnitGuess, FollowsTheTable) {
    const struct {
        double extent;
        LengthUnit unit;
        bool inDoubt;
    } table[] = {
        {1e-7, LengthUnit::Metre, false},      {1.52, LengthUnit::Metre, false},
        {2.999, LengthUnit::Metre, false},     {3, LengthUnit::Centimetre, true},
        {25, LengthUnit::Centimetre, true},    {25.1, LengthUnit::Centimetre, false},
        {149, LengthUnit::Centimetre, false},  {150, LengthUnit::Centimetre, true},
        {250, LengthUnit::Centimetre, true},   {250.1, LengthUnit::Millimetre, true},
        {350, LengthUnit::Millimetre, true},   {351, LengthUnit::Millimetre, false},
        {1520, LengthUnit::Millimetre, false}, {1e300, LengthUnit::Millimetre, false},
    };

    for (const auto& row : table) {
        const UnitGuess guess = guessUnit(row.extent);
        EXPECT_EQ(guess.unit, row.unit) << row.extent;
        EXPECT_EQ(guess.inDoubt, row.inDoubt) << row.extent;
    }
}

TEST(UnitGuess, SaysWhy) {
    EXPECT_EQ(guessUnit(1.52).reason, "largest extent 1.52, read as metres: 1520 mm");
    EXPECT_EQ(guessUnit(1.0 / 3).reason, "largest extent 0.3333, read as metres: 333.3 mm");
    EXPECT_EQ(guessUnit(14.8).reason, "largest extent 14.8, read as decimetres: 1480 mm");
    EXPECT_EQ(guessUnit(66).reason, "largest extent 66, read as centimetres: 660 mm");
    EXPECT_EQ(guessUnit(12.3456).reason, "largest extent 12.35, read as centimetres: 123.5 mm");
    EXPECT_EQ(guessUnit(15234.5).reason, "largest extent 15234, read as millimetres");
    EXPECT_EQ(guessUnit(1e-7).reason, "largest extent 0.0000001, read as metres: 0.0001 mm");
}

TEST(UnitGuess, IsInDoubtWithoutASize) {
    for (const double extent : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity()}) {
        EXPECT_TRUE(guessUnit(extent).inDoubt);
        EXPECT_EQ(guessUnit(extent).unit, LengthUnit::Millimetre);
    }
}

}  // namespace
}  // namespace toile
