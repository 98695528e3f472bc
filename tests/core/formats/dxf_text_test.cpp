// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/dxf/dxf_text.h"

#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/formats/read_pattern.h"
#include "tests/core/formats/dxf_builder.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

using test::DxfBuilder;

/// A piece with this name as it lies in the file.
PatternFile fileNamed(std::string_view name, std::string_view page, std::string_view version) {
    DxfBuilder text;
    text.section("HEADER").tag(9, "$ACADVER").tag(1, version);
    if (!page.empty()) {
        text.tag(9, "$DWGCODEPAGE").tag(3, page);
    }
    const Points2 square = (Points2(4, 2) << 0, 0, 400, 0, 400, 300, 0, 300).finished();
    text.end().section("BLOCKS").block("a").text("Piece Name: " + std::string(name));
    text.polyline("1", square, true).endBlock().end().section("ENTITIES").text("Units: METRIC");
    const auto file = readDxfPattern(text.end().take());
    EXPECT_TRUE(file);
    return file ? *file : PatternFile{};
}

TEST(DxfText, NamesAreReadByTheCodePage) {
    const struct {
        const char *bytes, *page, *name;
    } cases[] = {{"\xCF\xE5\xF0\xE5\xE4", "ANSI_1251", "Перед"},
                 {"\xC7\xB0\xC6\xAC", "ANSI_936", "前片"},
                 {"\xC7\xB0\xC6\xAC", "gb2312", "前片"},
                 {"\x91\x4F\x90\x67\x8D\xA0", "ANSI_932", "前身頃"},
                 {"R\xFC"
                  "cken \x80",
                  "ANSI_1252", "Rücken €"},
                 {"\xA3okie\xE6", "ANSI_1250", "Łokieć"},
                 {"\xBE\xD5\xC6\xC7", "ANSI_949", "앞판"},
                 {"\xAB\x65\xA4\xF9", "ANSI_950", "前片"},
                 {"R\x81"
                  "cken",
                  "dos850", "Rücken"},
                 {"R\xFC"
                  "cken",
                  "8859_1", "Rücken"}};
    for (const auto& [bytes, page, name] : cases) {
        const PatternFile file = fileNamed(bytes, page, "AC1009");
        ASSERT_EQ(file.pieces.size(), 1u);
        EXPECT_EQ(file.pieces[0].name, name) << page;
        EXPECT_TRUE(file.notes.empty()) << page << file.notes.front();
    }
}

TEST(DxfText, ValidUtf8IsUtf8WhateverThePage) {
    for (const char* page : {"", "ANSI_1252", "ANSI_936", "nonsense"}) {
        for (const char* version : {"AC1009", "AC1021", "AC1032"}) {
            const PatternFile file = fileNamed("前片 Rücken", page, version);
            EXPECT_EQ(file.pieces.at(0).name, "前片 Rücken") << page << version;
            EXPECT_TRUE(file.notes.empty());
        }
    }
    EXPECT_EQ(fileNamed("Rücken", "ANSI_1252", "AC1009").pieces.at(0).name, "Rücken");
    EXPECT_EQ(fileNamed("Rücken", "ANSI_936", "AC1021").pieces.at(0).name, "Rücken");
}

TEST(DxfText, AnUnknownPageIsSaid) {
    for (const char* page : {"", "klingon", "../../x", "ANSI_99999"}) {
        const PatternFile file = fileNamed(
            "R\xFC"
            "cken",
            page, "AC1009");
        EXPECT_EQ(file.pieces.at(0).name, "Rücken");  // Western European by guess
        ASSERT_EQ(file.notes.size(), 1u);
        EXPECT_NE(file.notes[0].find("code page"), std::string::npos);
    }
    EXPECT_EQ(fileNamed("\xC7\xB0\xC6\xAC", "", "AC1009").notes.size(), 1u);  // Chinese, or not
    EXPECT_EQ(fileNamed("\xFF", "ANSI_936", "AC1009").notes.size(), 1u);
}

TEST(DxfText, EscapesAreTheirCharacters) {
    EXPECT_EQ(withoutDxfEscapes("\\U+524D\\U+7247"), "前片");
    EXPECT_EQ(withoutDxfEscapes("a\\U+00e9b"), "aéb");
    EXPECT_EQ(withoutDxfEscapes("\\U+D83D\\U+DC57"), "👗");
    EXPECT_EQ(withoutDxfEscapes("\\M+5C7B0\\M+1914F"), "前前");
    EXPECT_EQ(withoutDxfEscapes("%%c30 %%D %%p1 100%%% %%uline%%u %%065"), "⌀30 ° ±1 100% line A");
    for (const char* none : {"\\U+12", "\\U+zzzz", "\\M+9ABCD", "\\M+", "%%", "%%x", "100 %"}) {
        EXPECT_EQ(withoutDxfEscapes(none), none);
    }
    EXPECT_EQ(fileNamed("\\U+524D\\U+7247", "ANSI_1252", "AC1009").pieces.at(0).name, "前片");
}

TEST(DxfText, MTextHasNoFormatting) {
    EXPECT_EQ(plainMText("{\\fArial|b0|i0;\\H2.5x;Front} \\Lleft\\l\\Pcut 2"), "Front left cut 2");
    EXPECT_EQ(plainMText("a\\\\b\\{c\\}"), "a\\b{c}");
    EXPECT_EQ(plainMText("end\\"), "end\\");
}

TEST(DxfText, ReadsTheNamesOfOtherPrograms) {
    const std::pair<const char*, const char*> files[] = {{"name_1251", "Перед"},
                                                         {"name_gbk_936", "前片"},
                                                         {"name_uplus", "前片"},
                                                         {"name_utf8", "前片"}};
    for (const auto& [file, name] : files) {
        const auto path = test::dataFile("reports/dxf-codepage/" + std::string(file) + ".dxf");
        TOILE_NEEDS_SHARED(path);
        EXPECT_EQ(readDxfPattern(*readFile(path))->pieces.at(0).name, name) << file;
    }
    const auto path = test::dataFile("reports/dxf-codepage/name_gbk_nopage.dxf");
    TOILE_NEEDS_SHARED(path);
    EXPECT_FALSE(readDxfPattern(*readFile(path))->notes.empty());
}

}  // namespace
}  // namespace toile
