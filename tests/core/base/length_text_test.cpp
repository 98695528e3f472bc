// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/base/units.h"

namespace toile {
namespace {

const LengthFormat kMm{}, kCm{LengthUnit::Centimetre, 0, "."},
    kGermanCm{LengthUnit::Centimetre, 0, ","}, kInch{LengthUnit::Inch, 0, "."},
    kEighths{LengthUnit::Inch, 8, "."}, kSixteenths{LengthUnit::Inch, 16, "."};

struct Row {
    const char* typed;
    LengthFormat format;
    double millimetres;
    const char* written;
};

TEST(LengthText, TypedIsReadAndWrittenBack) {
    const Row rows[] = {
        {"314", kMm, 314, "314.0 mm"},
        {"314 mm", kCm, 314, "31.40 cm"},
        {"31,4 cm", kMm, 314, "314.0 mm"},
        {"31.4CM", kGermanCm, 314, "31,40 cm"},
        {" 0,5 m ", kGermanCm, 500, "50,00 cm"},
        {"12 3/8\"", kSixteenths, 314.325, "12 3/8 in"},
        {"12 3/8", kSixteenths, 314.325, "12 3/8 in"},
        {"12⅜ in", kMm, 314.325, "314.3 mm"},
        {"12.375 inch", kEighths, 314.325, "12 3/8 in"},
        {"3/8", kEighths, 9.525, "3/8 in"},
        {"-3/8 in", kEighths, -9.525, "-3/8 in"},
        {"−3/8 in", kEighths, -9.525, "-3/8 in"},
        {"½″", kEighths, 12.7, "1/2 in"},
        {"1 in", kInch, 25.4, "1.00 in"},
        {"10 Zoll", kCm, 254, "25.40 cm"},
        {"2 * 45 mm + 1 in", kMm, 115.4, "115.4 mm"},
        {"45 mm * 2", kMm, 90, "90.0 mm"},
        {"1 in / 2", kMm, 12.7, "12.7 mm"},
        {"5 + 5 mm", kCm, 55, "5.50 cm"},
        {"10 cm - 1,5cm", kMm, 85, "85.0 mm"},
        {"0", kEighths, 0, "0 in"},
        {"10\u00a0mm", kMm, 10, "10.0 mm"},
    };
    for (const Row& row : rows) {
        const auto read = parseLength(row.typed, row.format);
        ASSERT_TRUE(read) << row.typed;
        EXPECT_NEAR(*read, row.millimetres, 1e-9) << row.typed;
        EXPECT_EQ(lengthText(*read, row.format), row.written) << row.typed;
        const auto again = parseLength(row.written, kMm);
        ASSERT_TRUE(again) << row.written;
        EXPECT_NEAR(*again, *read, 0.06) << row.written;
    }
}

TEST(LengthText, WhatIsNoLengthIsRefused) {
    for (const char* typed : {"",
                              " ",
                              "abc",
                              "12 mm mm",
                              "1.234,5",
                              "1,2,3",
                              "mm",
                              "3/0",
                              "5 / 0",
                              "5 mm * 3 mm",
                              "5 mm / 3 mm",
                              "12 3/8 4",
                              "1 +",
                              "+ - 1",
                              "nan",
                              "inf",
                              "1e5",
                              "12'",
                              "-",
                              ".",
                              "5 furlong",
                              "99999999999999999999"}) {
        EXPECT_FALSE(parseLength(typed, kMm)) << typed;
    }
}

TEST(LengthText, FractionsAreTheNearestAndShort) {
    for (const int denominator : {8, 16, 32}) {
        const LengthFormat format{LengthUnit::Inch, denominator, "."};
        for (double mm = -120; mm <= 120; mm += 0.37) {
            const auto back = parseLength(lengthNumber(mm, format), format);
            ASSERT_TRUE(back) << lengthNumber(mm, format);
            EXPECT_LE(std::abs(*back - mm), 25.4 / denominator / 2 + 1e-9)
                << lengthNumber(mm, format);
        }
    }
    EXPECT_EQ(lengthNumber(25.4 * 63.99 / 64, kEighths), "1");
    EXPECT_EQ(lengthNumber(-0.1, kEighths), "0");
    EXPECT_EQ(lengthNumber(25.4 * 6 / 16, kSixteenths), "3/8");
}

TEST(LengthText, NothingIsWrittenOfWhatIsNoNumber) {
    EXPECT_EQ(lengthText(std::nan(""), kMm), "– mm");
    EXPECT_EQ(lengthText(std::numeric_limits<double>::infinity(), kEighths), "– in");
}

TEST(LengthText, AnglesAreInDegrees) {
    constexpr double kDegree = std::numbers::pi / 180;
    EXPECT_EQ(angleText(45 * kDegree, 2, "."), "45°");
    EXPECT_EQ(angleText(-12.5 * kDegree, 2, ","), "-12,5°");
    EXPECT_EQ(angleText(-1e-9, 1, "."), "0°");
    for (const auto& [typed, degrees] : std::initializer_list<std::pair<const char*, double>>{
             {"45", 45}, {"12,5°", 12.5}, {"-30 deg", -30}, {"90 - 12.5", 77.5}, {"180/4", 45}}) {
        const auto read = parseAngle(typed);
        ASSERT_TRUE(read) << typed;
        EXPECT_NEAR(*read, degrees * kDegree, 1e-12) << typed;
    }
    EXPECT_FALSE(parseAngle("north"));
    EXPECT_FALSE(parseAngle("45 mm"));
}

}  // namespace
}  // namespace toile
