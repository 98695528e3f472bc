// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/pdf/pdf_writer.h"

#include <algorithm>
#include <charconv>

#include <gtest/gtest.h>

#include "core/formats/drawing/sheet_drawing.h"
#include "core/formats/export_file.h"
#include "core/formats/formats.h"
#include "core/formats/pdf/pdf_content.h"
#include "core/toile/pipeline.h"
#include "tests/core/formats/export_fixtures.h"
#include "tests/core/readers/pdf_read_back.h"
#include "tests/core/readers/pdf_reader.h"
#include "tests/core/support/laid_rows.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

constexpr Paper kPapers[] = {Paper::A4,      Paper::Letter,   Paper::Shared,  Paper::A0,
                             Paper::ArchD,   Paper::ArchE,    Paper::Roll610, Paper::Roll841,
                             Paper::Roll914, Paper::Projector};

struct Drawn {
    Pattern pattern;
    Drawing drawing;
};

Drawn handmade() {
    Drawn made{test::sewingPattern(), {}};
    made.drawing = draw(made.pattern, placeCopies(made.pattern));
    return made;
}

/// With allowances, notches and fair lines.
Drawn sewn(const std::string& file) {
    Progress progress;
    const auto garment = loadGarment({test::dataFile(file)}, {}, progress);
    EXPECT_TRUE(garment);
    const LineSettings lines = withPattern({});
    const PieceResults results = flattenGarment(*garment, {}, progress, 0, lines);
    LaidOutPattern laid = inRows(*garment, results, lines);
    Drawn made{laid.pattern, draw(laid.pattern, laid.marker)};
    return made;
}

const Drawn& shirt() {
    static const Drawn made = sewn("samples/tshirt.obj");
    return made;
}

std::string written(const Drawn& made, const PdfOptions& options = {}) {
    auto bytes = writePdf(made.drawing, made.pattern, options);
    EXPECT_TRUE(bytes) << (bytes ? "" : sentence(bytes.error()));
    return bytes ? *bytes : "";
}

std::size_t numberAt(std::string_view text) {
    std::size_t value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

TEST(WritePdf, ListsEveryObjectWhereItIs) {
    const std::string bytes = written(handmade());
    ASSERT_TRUE(bytes.starts_with("%PDF-1.7\n"));
    ASSERT_TRUE(bytes.ends_with("%%EOF\n"));
    const std::size_t table = numberAt(bytes.substr(bytes.rfind("startxref") + 10));
    const std::string_view rest = std::string_view(bytes).substr(table);
    ASSERT_TRUE(rest.starts_with("xref\n0 "));
    const std::size_t count = numberAt(rest.substr(7));
    ASSERT_GT(count, 10U);
    const std::size_t first = rest.find('\n', 7) + 1;
    for (std::size_t k = 1; k < count; ++k) {
        const std::string_view entry = rest.substr(first + 20 * k, 20);
        EXPECT_TRUE(entry.ends_with(" 00000 n \n"));
        const std::size_t offset = std::stoul(std::string(entry.substr(0, 10)));
        EXPECT_TRUE(
            std::string_view(bytes).substr(offset).starts_with(std::to_string(k) + " 0 obj\n"))
            << k;
    }
    EXPECT_TRUE(rest.substr(first + 20 * count).starts_with("trailer\n"));
}

TEST(WritePdf, GivesTheSameBytesTwiceAndUnderAnyLocale) {
    for (const Paper paper : {Paper::A4, Paper::Projector}) {
        const std::string once = written(shirt(), {paper, 10});
        EXPECT_EQ(written(shirt(), {paper, 10}), once);
        const test::CommaLocale comma;
        EXPECT_EQ(written(shirt(), {paper, 10}), once);
        EXPECT_TRUE(readBackPdf(once, shirt().drawing, {paper, 10}));
    }
}

TEST(WritePdf, HasNoDatesAndTellsViewersNotToScale) {
    const std::string bytes = written(handmade());
    EXPECT_EQ(bytes.find("Date"), std::string::npos);
    EXPECT_NE(bytes.find("/PrintScaling /None"), std::string::npos);
    EXPECT_EQ(bytes.find("UserUnit"), std::string::npos);
    EXPECT_NE(bytes.find("[0 0 595.2756 841.8898]"), std::string::npos);
}

TEST(WritePdf, IsReadBackOnEveryPaper) {
    const Drawn made = handmade();
    Drawn none{made.pattern, {}};  // nothing is flat
    none.pattern.pieces.clear();
    none.drawing = draw(none.pattern, placeCopies(none.pattern));
    for (const Drawn* drawn : {&made, &shirt(), static_cast<const Drawn*>(&none)}) {
        for (const Paper paper : kPapers) {
            for (const double overlap : {0.0, 10.0, 50.0}) {
                const PdfOptions options{paper, overlap};
                const auto found = readBackPdf(written(*drawn, options), drawn->drawing, options);
                ASSERT_TRUE(found) << sentence(found.error());
                EXPECT_EQ(found->pieces, static_cast<int>(drawn->drawing.blocks.size()));
                EXPECT_LE(found->largest, 0.04);
            }
        }
    }
}

TEST(WritePdf, ListsALayerForEachKindAndHidesTheGrid) {
    const auto read = readPdf(written(shirt(), {Paper::Projector, 10}));
    ASSERT_TRUE(read) << sentence(read.error());
    for (const LayerKind kind : kLayerKinds) {
        EXPECT_EQ(std::ranges::count(read->layers, pdfLayerName(static_cast<int>(kind))),
                  hasLayer(shirt().drawing, kind) ? 1 : 0);
    }
    EXPECT_EQ(read->layers.back(), "grid");
    EXPECT_EQ(read->hiddenLayers, std::vector<std::string>{"grid"});
    const auto tiles = readPdf(written(shirt()));
    ASSERT_TRUE(tiles);
    EXPECT_EQ(tiles->layers.back(), "pages");
    EXPECT_TRUE(tiles->hiddenLayers.empty());
}

TEST(WritePdf, NumbersItsPagesAndBeginsWithTheMap) {
    const auto read = readPdf(written(shirt()));
    ASSERT_TRUE(read);
    ASSERT_GT(read->pages.size(), 2U);
    EXPECT_TRUE(read->pages.front().views.empty());
    EXPECT_EQ(read->pages.front().lines.size(), 2U);  // the squares
    for (std::size_t k = 1; k < read->pages.size(); ++k) {
        EXPECT_EQ(read->pages[k].views.size(), 1U);
    }
}

TEST(WritePdf, GivesAPatternItsSheetAndTheSquaresTheMap) {
    // With the check square beside it the piece would need another sheet.
    Drawn made{{"apron", {{{}, "apron", "apron", test::rectangle(0, 0, 1100, 700)}}}, {}};
    made.drawing = draw(made.pattern, placeCopies(made.pattern));
    const PdfOptions options{Paper::A0, 10};
    const std::string bytes = written(made, options);
    const auto read = readPdf(bytes);
    ASSERT_TRUE(read);
    ASSERT_EQ(read->pages.size(), 2U);
    EXPECT_EQ(read->pages[0].lines.size(), 2U);
    EXPECT_TRUE(readBackPdf(bytes, made.drawing, options));
}

TEST(WritePdf, DrawsFairSeamLinesAsCurves) {
    PdfLetters letters;
    PdfContent out(letters);
    drawPattern(out, shirt().drawing, shirt().pattern, {LayerKind::Sew});
    const std::string content = out.take();
    std::size_t curves = 0, lines = 0;
    for (std::size_t at = 0; (at = content.find('\n', at)) != std::string::npos; ++at) {
        curves += at > 0 && content[at - 1] == 'c';
        lines += at > 0 && content[at - 1] == 'l';
    }
    EXPECT_GT(curves, shirt().drawing.blocks.size());
    std::size_t points = 0;
    for (const PatternPiece& piece : shirt().pattern.pieces) {
        points += static_cast<std::size_t>(piece.outline.rows());
    }
    EXPECT_LT(curves + lines, points);
}

TEST(WritePdf, RefusesAProjectorsPageThatWouldBeTooLong) {
    Drawn made = handmade();
    made.pattern.pieces.push_back({{}, "sash", "sash", test::rectangle(0, 0, 5200, 30)});
    made.drawing = draw(made.pattern, placeCopies(made.pattern));
    const auto refused = writePdf(made.drawing, made.pattern, {Paper::Projector, 10});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::PageTooSmall);
    EXPECT_NE(sentence(refused.error()).find("5080 mm"), std::string::npos);
    const PdfOptions roll{Paper::Roll914, 10};
    const auto found = readBackPdf(written(made, roll), made.drawing, roll);
    EXPECT_TRUE(found) << sentence(found.error());
}

TEST(ReadBackPdf, RefusesADrawingThatIsAnother) {
    const Drawn made = handmade();
    const std::string bytes = written(made);
    Drawing other = made.drawing;
    other.paths[1].points(2, 0) += 0.05;
    auto found = readBackPdf(bytes, other, {});
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().code, ErrorCode::NotReadBack);
    EXPECT_NE(found.error().detail.find(other.paths[1].id), std::string::npos);
    other = made.drawing;
    other.paths.push_back(other.paths[0]);
    other.paths.back().id = "one-more";
    EXPECT_FALSE(readBackPdf(bytes, other, {}));
}

TEST(ReadBackPdf, RefusesAnotherPaperAndBytesThatWereChanged) {
    const Drawn made = handmade();
    std::string bytes = written(made);
    EXPECT_FALSE(readBackPdf(bytes, made.drawing, {Paper::Letter, 10}));
    EXPECT_FALSE(readBackPdf(bytes, made.drawing, {Paper::Projector, 10}));
    const std::size_t box = bytes.find("595.2756 841.8898");
    ASSERT_NE(box, std::string::npos);
    bytes.replace(box, 17, "595.2756 841.9898");
    const auto found = readBackPdf(bytes, made.drawing, {});
    ASSERT_FALSE(found);
    EXPECT_NE(found.error().detail.find("page 1"), std::string::npos);
    // The drawing, which is the last form, is no longer what was packed.
    bytes = written(made);
    const std::size_t stream = bytes.rfind("/Subtype /Form");
    ASSERT_NE(stream, std::string::npos);
    bytes[bytes.find("stream\n", stream) + 2000] ^= 1;
    EXPECT_FALSE(readBackPdf(bytes, made.drawing, {}));
}

TEST(PdfFile, WritesTextsAndNumbersAsReadersExpect) {
    EXPECT_EQ(pdfText("a (b) \\"), "(a \\(b\\) \\\\)");
    EXPECT_EQ(pdfText("Größe"), "<FEFF0047007200F600DF0065>");
    EXPECT_EQ(pdfText("\xF0\x9F\x91\x97"), "<FEFFD83DDC57>");
    EXPECT_EQ(pdfNumber(1.5), "1.5");
    EXPECT_EQ(pdfNumber(100), "100");
    EXPECT_EQ(pdfNumber(-0.00001), "0");
    EXPECT_EQ(pdfPoints(25.4), "72");
}

}  // namespace
}  // namespace toile
