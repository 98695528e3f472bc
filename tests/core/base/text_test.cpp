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
    for (const LengthUnit unit : kLengthUnits) {
        EXPECT_EQ(parseLengthUnit(symbol(unit)), unit);
    }
    EXPECT_DOUBLE_EQ(millimetresPer(LengthUnit::Inch), 25.4);
    EXPECT_FALSE(parseLengthUnit("ell"));
}

TEST(FileUnits, AreNamedOrAnyLength) {
    for (const LengthUnit unit : kLengthUnits) {
        EXPECT_EQ(FileUnit(unit).named(), unit);
        EXPECT_EQ(parseFileUnit(symbol(unit)), FileUnit(unit));
        EXPECT_EQ(unitText(unit), symbol(unit));
    }
    for (const double millimetres : {1800 / 14.77, 1e-3, 1.0 / 3, 98765.4321}) {
        const auto unit = FileUnit::ofMillimetres(millimetres);
        ASSERT_TRUE(unit);
        EXPECT_EQ(unit->millimetres(), millimetres);
        EXPECT_FALSE(unit->named());
        EXPECT_EQ(parseFileUnit(unitText(*unit)), unit);
    }
    EXPECT_EQ(parseFileUnit("0.5in"), FileUnit::ofMillimetres(12.7));
    EXPECT_EQ(parseFileUnit("10 mm"), FileUnit(LengthUnit::Centimetre));
    for (const char* text :
         {"", "ell", "3", "mm 3", "0 mm", "-1 mm", "inf mm", "nan mm", "1e9 m", "3  mm", "3 mm "}) {
        EXPECT_FALSE(parseFileUnit(text)) << text;
    }
}

TEST(Version, IsTheProjects) {
    EXPECT_EQ(version(), TOILE_VERSION);
}

}  // namespace
}  // namespace toile
