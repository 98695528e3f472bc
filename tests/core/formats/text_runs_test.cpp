// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/formats/drawing/text_outlines.h"

namespace toile {
namespace {

std::size_t oneFont(char32_t) {
    return 0;
}

std::vector<std::u32string> textsOf(std::string_view line) {
    std::vector<std::u32string> texts;
    for (const TextRun& run : textRuns(line, oneFont)) {
        texts.push_back(run.characters);
    }
    return texts;
}

using Texts = std::vector<std::u32string>;

TEST(TextRuns, LineOfOneScriptIsOneRun) {
    EXPECT_EQ(textsOf("Front, 2 x"), (Texts{U"Front, 2 x"}));
    EXPECT_EQ(textsOf("12/3"), (Texts{U"12/3"}));
    EXPECT_TRUE(textRuns("", oneFont).empty());
}

TEST(TextRuns, LettersThatRunToTheLeftAreOneRunAndKeepTheirOrderOfReading) {
    const std::vector<TextRun> runs = textRuns("\u05d0\u05d1 \u05d2", oneFont);
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_TRUE(runs.front().isRightToLeft);
    EXPECT_EQ(runs.front().characters, U"\u05d0\u05d1 \u05d2");
}

TEST(TextRuns, LineThatStartsToTheLeftHasItsEndOnTheLeft) {
    EXPECT_EQ(textsOf("\u05d0 12 \u05d1"), (Texts{U" \u05d1", U"12", U"\u05d0 "}));
    EXPECT_EQ(textsOf("\u05d0 1.5"), (Texts{U"1.5", U"\u05d0 "}));
    EXPECT_EQ(textsOf("\u05d0 abc"), (Texts{U"abc", U"\u05d0 "}));
}

TEST(TextRuns, WordsToTheLeftWithinALineToTheRightStayTogether) {
    const Texts texts = textsOf("ab \u05d0 \u05d1 cd");
    EXPECT_EQ(texts.front(), U"ab ");
    EXPECT_EQ(texts.back(), U"cd");
    EXPECT_EQ(texts[1], U"\u05d0 \u05d1");
}

TEST(TextRuns, AccentStaysInTheFontOfItsLetter) {
    const auto runs = textRuns("ae\u0301b", [](char32_t code) -> std::size_t {
        return code == U'\u0301' ? 3 : code == U'b' ? 2 : 1;
    });
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[0].characters, U"ae\u0301");
    EXPECT_EQ(runs[0].font, 1U);
    EXPECT_EQ(runs[1].font, 2U);
}

TEST(TextRuns, EveryCharacterIsInOneRun) {
    const std::string line = "a\u05d01\u0661 (\u65e5\u672c) \xff\xfe \u202e.";
    std::size_t count = 0;
    for (const TextRun& run : textRuns(line, oneFont)) {
        count += run.characters.size();
    }
    EXPECT_EQ(count, 15U);
}

}  // namespace
}  // namespace toile
