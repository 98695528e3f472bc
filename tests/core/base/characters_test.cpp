// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/characters.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(AsciiText, TakesAccentsOffLatinLetters) {
    EXPECT_EQ(asciiText("Rückenteil groß"), "Ruckenteil gross");
    EXPECT_EQ(asciiText("Ærmet Œuvre Łódź Çağ ñ ÿ Ÿ Å"), "AErmet OEuvre Lodz Cag n y Y A");
    EXPECT_EQ(asciiText("Перед Щит ёлка объём"), "Pered Shchit elka obieem");
    EXPECT_EQ(asciiText("Μανίκι Ψηλό Άνω"), "Maniki Psilo Ano");
    EXPECT_EQ(asciiText("cafe\xCC\x81"), "cafe");  // an accent of its own
    EXPECT_EQ(asciiText("plain-1_2 (3)"), "plain-1_2 (3)");
}

TEST(AsciiText, WritesAnUnderscoreForEveryOtherCharacter) {
    EXPECT_EQ(asciiText("前身頃"), "___");
    EXPECT_EQ(asciiText("a\nb\tc\x7F"), "a_b_c_");
    EXPECT_EQ(asciiText("\U0001F455 shirt"), "_ shirt");
}

TEST(CleanText, KeepsValidTextAndReplacesTheRest) {
    EXPECT_EQ(cleanText("前身頃 & <Ä> \U0001F455"), "前身頃 & <Ä> \U0001F455");
    EXPECT_EQ(cleanText("a\r\nb"), "a  b");
    EXPECT_EQ(cleanText("\xE4rmel"), "\xEF\xBF\xBDrmel");               // Latin-1
    EXPECT_EQ(cleanText("x\xE2\x82"), "x\xEF\xBF\xBD\xEF\xBF\xBD");     // cut off
    EXPECT_EQ(cleanText("\xC0\xAF"), "\xEF\xBF\xBD\xEF\xBF\xBD");       // longer than needed
    EXPECT_EQ(cleanText("\xED\xA0\x80").substr(0, 3), "\xEF\xBF\xBD");  // half a surrogate pair
    EXPECT_EQ(cleanText("\xEF\xBF\xBF").substr(0, 3), "\xEF\xBF\xBD");  // no character for XML
}

TEST(CleanText, TurnsNoWritingAround) {
    EXPECT_EQ(cleanText("a\u202Eb\u2066c\u2028d\u0085e"), "a b c d e");
    EXPECT_EQ(cleanText("ab\u200Dc"), "ab\u200Dc");  // joins letters
}

TEST(ReadableName, TakesOtherBytesForLatin1) {
    EXPECT_EQ(readableName("\xC4rmel"), "Ärmel");
    EXPECT_EQ(readableName("Ärmel \u202E\x1B[31m"), "Ärmel   [31m");
    EXPECT_EQ(readableName("\xEF\xBF\xBD"), "\xEF\xBF\xBD");
}

TEST(ShownText, IsShort) {
    EXPECT_EQ(shownText("前身頃", 3), "前身頃");
    EXPECT_EQ(shownText("前身頃x", 3), "前身頃…");
    EXPECT_EQ(characterCount(shownText(std::string(2000000, 'x'))), kMaxShown + 1);
}

TEST(CharacterCount, CountsCharactersNotBytes) {
    EXPECT_EQ(characterCount(""), 0u);
    EXPECT_EQ(characterCount("Größe"), 5u);
    EXPECT_EQ(characterCount("前身頃"), 3u);
}

}  // namespace
}  // namespace toile
