// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include <gtest/gtest.h>

#include "core/geometry/segment.h"
#include "tests/core/support/generator.h"

namespace toile {
namespace {

using Point = Eigen::RowVector2d;

/// Whole numbers below 2^53 in size, exactly.
struct WholePoint {
    std::int64_t x, y;

    Point asDoubles() const { return {static_cast<double>(x), static_cast<double>(y)}; }
};

/// A sum of products of whole numbers, in digits of 27 bits.
class WholeSum {
public:
    void addProduct(std::int64_t x, std::int64_t y) {
        const std::int64_t xHigh = x >> 27;  // rounds down, so that the low part is not negative
        const std::int64_t yHigh = y >> 27;
        const std::int64_t xLow = x - (xHigh * (std::int64_t{1} << 27));
        const std::int64_t yLow = y - (yHigh * (std::int64_t{1} << 27));
        digits_[0] += xLow * yLow;
        digits_[1] += xLow * yHigh + xHigh * yLow;
        digits_[2] += xHigh * yHigh;
    }

    int sign() const {
        const std::int64_t first = digits_[0] >> 27;
        const std::int64_t low = digits_[0] - (first * (std::int64_t{1} << 27));
        const std::int64_t second = (digits_[1] + first) >> 27;
        const std::int64_t middle = digits_[1] + first - (second * (std::int64_t{1} << 27));
        const std::int64_t high = digits_[2] + second;
        return high != 0 ? (high > 0 ? 1 : -1) : (middle != 0 || low != 0 ? 1 : 0);
    }

private:
    std::array<std::int64_t, 3> digits_{};
};

int wholeOrientation(const WholePoint& a, const WholePoint& b, const WholePoint& c) {
    WholeSum sum;
    sum.addProduct(a.x, b.y);
    sum.addProduct(-a.y, b.x);
    sum.addProduct(b.x, c.y);
    sum.addProduct(-b.y, c.x);
    sum.addProduct(c.x, a.y);
    sum.addProduct(-c.y, a.x);
    return sum.sign();
}

int plainOrientation(const Point& a, const Point& b, const Point& c) {
    const double d = (a.x() - c.x()) * (b.y() - c.y()) - (a.y() - c.y()) * (b.x() - c.x());
    return d > 0 ? 1 : (d < 0 ? -1 : 0);
}

TEST(ExactOrientation, KnowsLeftRightAndInLine) {
    EXPECT_EQ(geometry::exactOrientation({0, 0}, {1, 0}, {0, 1}), 1);
    EXPECT_EQ(geometry::exactOrientation({0, 0}, {1, 0}, {0, -1}), -1);
    EXPECT_EQ(geometry::exactOrientation({0.5, 0.5}, {12, 12}, {24, 24}), 0);
    EXPECT_EQ(geometry::exactOrientation({3, 4}, {3, 4}, {7, 1}), 0);
    EXPECT_EQ(geometry::exactOrientation({0.5, 0.5}, {12, 12}, {24, std::nextafter(24.0, 25.0)}),
              1);
}

TEST(ExactOrientation, AgreesWithWholeNumbersWhereRoundingDoesNot) {
    test::Generator random(7);
    const auto coordinate = [&](int bits) {
        return static_cast<std::int64_t>(random.bits() >> (64 - bits)) -
               (std::int64_t{1} << (bits - 1));
    };
    int roundedWrong = 0;
    std::array<int, 3> seen{};
    for (int k = 0; k < 20000; ++k) {
        // Two steps of which one is nearly a multiple of the other: their determinant is 1 or -1
        // (neighbours in a continued fraction), with entries up to 2^50.
        WholePoint step{1, 0};
        WholePoint next{random.whole(0, 9), 1};
        const std::int64_t limit = std::int64_t{1} << random.whole(20, 49);
        while (std::max(next.x, next.y) < limit) {
            const std::int64_t times = random.whole(1, 3);
            step = std::exchange(next, {step.x + times * next.x, step.y + times * next.y});
        }
        const WholePoint a{coordinate(51), coordinate(51)};
        const WholePoint b{a.x + step.x, a.y + step.y};
        const bool inLine = random.chance(0.3);
        const WholePoint c = inLine ? WholePoint{a.x - step.x, a.y - step.y}
                                    : WholePoint{a.x + next.x, a.y + next.y};
        const int exact = wholeOrientation(a, b, c);
        const Point p = a.asDoubles();
        const Point q = b.asDoubles();
        const Point r = c.asDoubles();
        ASSERT_EQ(geometry::exactOrientation(p, q, r), exact) << k;
        // The same determinant whichever point comes first.
        ASSERT_EQ(geometry::exactOrientation(q, r, p), exact) << k;
        ASSERT_EQ(geometry::exactOrientation(q, p, r), -exact) << k;
        // Scaled by a power of two, nothing changes.
        ASSERT_EQ(geometry::exactOrientation(0x1p-300 * p, 0x1p-300 * q, 0x1p-300 * r), exact) << k;
        roundedWrong += plainOrientation(p, q, r) != exact ? 1 : 0;
        ++seen[static_cast<std::size_t>(exact + 1)];
    }
    EXPECT_GT(roundedWrong, 0) << "the cases are too easy to show anything";
    for (const int count : seen) {
        EXPECT_GT(count, 100);
    }
}

TEST(ExactOrientation, SeesThroughRoundedDifferences) {
    // Kettner et al.: on this grid of neighbouring doubles plain arithmetic gives stripes.
    const double ulp = 0x1p-53;
    int roundedWrong = 0;
    for (int i = 0; i < 64; ++i) {
        for (int j = 0; j < 64; ++j) {
            const Point p(0.5 + i * ulp, 0.5 + j * ulp);
            const int exact = i == j ? 0 : (j > i ? 1 : -1);  // above or below the diagonal
            ASSERT_EQ(geometry::exactOrientation({12, 12}, {24, 24}, p), exact) << i << " " << j;
            roundedWrong += plainOrientation(p, {12, 12}, {24, 24}) != exact ? 1 : 0;
        }
    }
    EXPECT_GT(roundedWrong, 0);
}

}  // namespace
}  // namespace toile
