// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/readers/pdf_reader.h"

#include <random>

#include <gtest/gtest.h>

#include "core/formats/pdf/pdf_writer.h"
#include "tests/core/formats/export_fixtures.h"
#include "tests/core/readers/pdf_lexer.h"
#include "tests/core/readers/pdf_shown.h"

namespace toile {
namespace {

using Kind = PdfValue::Kind;

std::string smallPdf() {
    const Pattern pattern = test::sewingPattern();
    return *writePdf(draw(pattern, placeCopies(pattern)), pattern, {});
}

TEST(ReadPdf, ReadsValuesOfEveryKind) {
    PdfLexer lexer("<< /Name (a \\(b\\) c) /List [1 -2.5 3 0 R] /Hex <4 14A> >> % why\n12 Tf",
                   true);
    const auto value = lexer.next();
    ASSERT_TRUE(value && value->kind == Kind::Dictionary);
    EXPECT_EQ(value->find("Name")->text, "a (b) c");
    EXPECT_EQ(value->find("Hex")->text, "AJ");
    ASSERT_EQ(value->find("List")->items.size(), 3U);
    EXPECT_EQ(value->find("List")->items[1].number, -2.5);
    EXPECT_EQ(value->find("List")->items[2].kind, Kind::Reference);
    EXPECT_EQ(value->find("None"), nullptr);
    EXPECT_EQ(lexer.next()->number, 12);
    EXPECT_TRUE(lexer.next()->isWord("Tf"));
    EXPECT_FALSE(lexer.next());
}

TEST(ReadPdf, RefusesWhatIsNestedTooDeeplyOrNeverEnds) {
    for (const char* piece : {"[", "<<", "<</A ", "(", "<41", "/A[", "["}) {
        std::string deep;
        for (int k = 0; k < 100000; ++k) {
            deep += piece;
        }
        PdfLexer lexer(deep, true);
        while (const auto value = lexer.next()) {
            ASSERT_LE(lexer.at(), deep.size());
        }
    }
}

TEST(ReadPdf, RefusesEveryFileThatIsCutShort) {
    const std::string bytes = smallPdf();
    ASSERT_TRUE(readPdf(bytes));
    for (std::size_t length = 0; length + 6 < bytes.size(); length += 1 + length / 50) {
        const auto read = readPdf(std::string_view(bytes).substr(0, length));
        ASSERT_FALSE(read) << length;
        EXPECT_EQ(read.error().code, ErrorCode::MalformedFile);
    }
}

TEST(ReadPdf, TakesAnyBytes) {
    const std::string bytes = smallPdf();
    std::mt19937 random(7);
    for (int round = 0; round < 300; ++round) {
        std::string changed = bytes;
        for (int k = 0; k < 1 + round % 5; ++k) {
            // Half of them where the structure is: at the end.
            const std::size_t from = round % 2 == 0 ? 0 : changed.size() - changed.size() / 8;
            changed[from + random() % (changed.size() - from)] = static_cast<char>(random());
        }
        const auto read = readPdf(changed);  // whatever it says
        if (read) {
            EXPECT_FALSE(read->pages.empty());
        }
    }
}

TEST(ReadPdf, RefusesPointsThatAreOnNoPage) {
    for (const char* content : {"1e308 0 m S", "1e200 0 0 1 0 0 cm 1e200 0 m S",
                                "0 0 1e308 1 re W n", "0 0 m 0 0 1e10 0 9 9 c S"}) {
        EXPECT_FALSE(readPdfContent(content, {})) << content;
    }
    EXPECT_TRUE(readPdfContent("0 0 m 0 0 1e5 0 9 9 c S", {}));
}

TEST(ReadPdf, RefusesIdsOfMoreThanAName) {
    const auto marked = [](std::size_t length) {
        return "/Toile <</Id (" + std::string(length, 'a') + ")>> BDC EMC";
    };
    EXPECT_TRUE(readPdfContent(marked(50), {}));
    EXPECT_FALSE(readPdfContent(marked(5000), {}));
}

}  // namespace
}  // namespace toile
