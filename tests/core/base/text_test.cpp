// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/base/version.h"

namespace toile {
namespace {

TEST(Text, ShortestDigitsReadBack) {
    for (const double value : {0.1, 1.0 / 3, 1e-300, -123456.789, 5e22, 0.0}) {
        EXPECT_EQ(std::stod(shortest(value)), value);
    }
    EXPECT_EQ(shortest(0.1), "0.1");
    EXPECT_EQ(shortest(250), "250");
}

TEST(Text, FixedDecimalsNeverShowANegativeZero) {
    EXPECT_EQ(fixed(1.23456, 4), "1.2346");
    EXPECT_EQ(fixed(-0.00001, 4), "0.0000");
    EXPECT_EQ(fixed(-0.5, 1), "-0.5");
    EXPECT_EQ(fixed(1e20, 0), "100000000000000000000");
    EXPECT_EQ(fixed(1e308, 2).size(), 309U + 3U);
}

TEST(Text, CountsAndSlugs) {
    EXPECT_EQ(counted(1, "face"), "1 face");
    EXPECT_EQ(counted(2, "face"), "2 faces");
    EXPECT_EQ(counted(3, "vertex"), "3 vertices");
    EXPECT_EQ(slug("Sleeve  Left (2)"), "sleeve-left-2");
    EXPECT_EQ(slug("\xC3\x84rmel"), "rmel");
    EXPECT_EQ(slug("  "), "piece");
}

TEST(LengthUnits, ReadBackTheirSymbols) {
    for (const LengthUnit unit :
         {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre, LengthUnit::Inch}) {
        EXPECT_EQ(parseLengthUnit(symbol(unit)), unit);
    }
    EXPECT_DOUBLE_EQ(millimetresPer(LengthUnit::Inch), 25.4);
    EXPECT_FALSE(parseLengthUnit("ell"));
}

TEST(Version, IsTheProjects) {
    EXPECT_EQ(version(), TOILE_VERSION);
}

}  // namespace
}  // namespace toile
