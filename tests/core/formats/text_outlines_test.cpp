// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/drawing/text_outlines.h"

#include <cmath>
#include <string>
#include <thread>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace toile {
namespace {

constexpr double kHeight = 7;  // mm

bool hasFonts() {
    return !textOutlines("H", kHeight).contours.empty();
}

#define TOILE_NEEDS_FONT()                                            \
    if (!hasFonts()) {                                                \
        GTEST_SKIP() << "No font, such as that of fonts-dejavu-core"; \
    }

double areaOf(const std::vector<CubicCurve>& contour) {
    const Points2 points = sampled(contour, 16);
    double area = 0;
    for (Eigen::Index k = 0; k + 1 < points.rows(); ++k) {
        area += points(k, 0) * points(k + 1, 1) - points(k, 1) * points(k + 1, 0);
    }
    return area / 2;
}

Eigen::AlignedBox2d boxOf(const TextOutlines& text) {
    Eigen::AlignedBox2d box;
    for (const auto& contour : text.contours) {
        const Points2 points = sampled(contour, 16);
        for (Eigen::Index k = 0; k < points.rows(); ++k) {
            box.extend(points.row(k).transpose());
        }
    }
    return box;
}

/// Closed chains of finite curves.
void expectClosed(const TextOutlines& text) {
    EXPECT_TRUE(std::isfinite(text.width));
    for (const auto& contour : text.contours) {
        ASSERT_FALSE(contour.empty());
        for (std::size_t k = 0; k < contour.size(); ++k) {
            EXPECT_EQ(contour[k].end, contour[(k + 1) % contour.size()].start);
            EXPECT_TRUE(contour[k].startHandle.allFinite() && contour[k].endHandle.allFinite());
        }
    }
}

/// Letters of a script that no font has are its boxes, all alike; skips by name.
bool isDrawn(const char* first, const char* second) {
    const auto a = textOutlines(first, kHeight), b = textOutlines(second, kHeight);
    return !a.contours.empty() && !b.contours.empty() &&
           (a.contours.size() != b.contours.size() ||
            areaOf(a.contours[0]) != areaOf(b.contours[0]));
}

bool isSame(const TextOutlines& a, const TextOutlines& b) {
    if (a.width != b.width || a.contours.size() != b.contours.size()) {
        return false;
    }
    for (std::size_t k = 0; k < a.contours.size(); ++k) {
        if (a.contours[k].size() != b.contours[k].size() ||
            sampled(a.contours[k], 3) != sampled(b.contours[k], 3)) {
            return false;
        }
    }
    return true;
}

TEST(TextOutlines, CapitalIsAsHighAsAsked) {
    TOILE_NEEDS_FONT();
    const Eigen::AlignedBox2d box = boxOf(textOutlines("H", kHeight));
    EXPECT_NEAR(box.min().y(), 0, 1e-9);
    EXPECT_NEAR(box.max().y(), kHeight, 1e-9);
    EXPECT_NEAR(boxOf(textOutlines("E", 2 * kHeight)).max().y(), 2 * kHeight, 1e-9);
}

TEST(TextOutlines, WidthGrowsWithTheTextAndHoldsIt) {
    TOILE_NEEDS_FONT();
    std::string text;
    double width = textOutlines(text, kHeight).width;
    EXPECT_EQ(width, 0);
    for (const char letter : {'F', 'r', 'o', 'n', 't', ' ', '2'}) {
        text += letter;
        const TextOutlines outlines = textOutlines(text, kHeight);
        EXPECT_GT(outlines.width, width);
        EXPECT_GT(boxOf(outlines).min().x(), -0.2 * kHeight);
        EXPECT_LT(boxOf(outlines).max().x(), outlines.width + 0.2 * kHeight);
        width = outlines.width;
    }
}

TEST(TextOutlines, RingHasTwoContoursOfOppositeWinding) {
    TOILE_NEEDS_FONT();
    const TextOutlines ring = textOutlines("O", kHeight);
    ASSERT_EQ(ring.contours.size(), 2U);
    expectClosed(ring);
    EXPECT_LT(areaOf(ring.contours[0]) * areaOf(ring.contours[1]), 0);
}

TEST(TextOutlines, ScalesWithTheHeight) {
    TOILE_NEEDS_FONT();
    const TextOutlines one = textOutlines("Rock", 1), ten = textOutlines("Rock", 10);
    EXPECT_NEAR(10 * one.width, ten.width, 1e-9);
    EXPECT_TRUE((10 * boxOf(one).max()).isApprox(boxOf(ten).max(), 1e-9));
}

TEST(TextOutlines, LetterWithDotsHasContours) {
    TOILE_NEEDS_FONT();
    const TextOutlines plain = textOutlines("Armel", kHeight);
    const TextOutlines dotted = textOutlines("\u00c4rmel", kHeight);
    EXPECT_EQ(dotted.contours.size(), plain.contours.size() + 2);
    EXPECT_NEAR(dotted.width, plain.width, 1e-9);
}

TEST(TextOutlines, JapaneseIsDrawn) {
    if (!isDrawn("\u524d", "\u8896")) {
        GTEST_SKIP() << "No Japanese font, such as that of fonts-ipafont-gothic";
    }
    const TextOutlines text = textOutlines("\u524d\u8eab\u9803 Front", kHeight);
    expectClosed(text);
    EXPECT_GT(text.width, textOutlines(" Front", kHeight).width + 3 * kHeight);
}

TEST(TextOutlines, ArabicIsDrawnJoinedAndFromTheRight) {
    if (!isDrawn("\u0643", "\u0645")) {
        GTEST_SKIP() << "No Arabic font, such as that of fonts-dejavu-core";
    }
    // A letter that is joined is narrower than one that stands alone.
    const double alone = textOutlines("\u0643", kHeight).width;
    EXPECT_LT(textOutlines("\u0643\u0643\u0643\u0643", kHeight).width, 4 * alone - 0.1);
    // The letter read first is the one on the right.
    const TextOutlines alef = textOutlines("\u0627 \u0645", kHeight);
    const TextOutlines last = textOutlines("\u0645", kHeight);
    EXPECT_NEAR(boxOf({{alef.contours.front()}, 0}).min().x(),
                boxOf({{last.contours.front()}, 0}).min().x(), 1e-9);
    expectClosed(alef);
}

TEST(TextOutlines, UnknownCharactersAndBadBytesDoNoHarm) {
    for (const std::string& text :
         {std::string("\xff\xfe\x80"), std::string("a\0b", 3), std::string("\xed\xa0\x80"),
          std::string("\U0010fffd\u0378"), std::string("\u0301"), std::string("\u200d\u202e\n\t"),
          std::string("\xf0\x9f\x98"), std::string("\U0001f600")}) {
        expectClosed(textOutlines(text, kHeight));
    }
    EXPECT_TRUE(textOutlines("", kHeight).contours.empty());
    expectClosed(textOutlines("H", 0));
}

TEST(TextOutlines, SameFromSeveralThreads) {
    const std::string text = "\u00c4rmel \u0643\u0645 \u524d";
    const TextOutlines expected = textOutlines(text, kHeight);
    std::vector<TextOutlines> got(8);
    std::vector<std::thread> threads;
    for (TextOutlines& mine : got) {
        threads.emplace_back([&mine, &text] {
            for (int k = 0; k < 20; ++k) {
                mine = textOutlines(text, kHeight);
            }
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (const TextOutlines& mine : got) {
        EXPECT_TRUE(isSame(mine, expected));
    }
}

}  // namespace
}  // namespace toile
