// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/formats/dxf/dxf_curve.h"
#include "core/formats/read_pattern.h"
#include "core/formats/writers.h"
#include "core/geometry/polygon.h"
#include "tests/core/formats/dxf_builder.h"
#include "tests/core/formats/export_fixtures.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

using test::DxfBuilder;

Points2 lineThrough(std::initializer_list<std::array<double, 2>> places) {
    Points2 line(static_cast<Eigen::Index>(places.size()), 2);
    Eigen::Index row = 0;
    for (const auto& place : places) {
        line.row(row++) << place[0], place[1];
    }
    return line;
}

const Points2 kPanelOutline = lineThrough(
    {{0, 0}, {400, 0}, {400, 300}, {250, 500}, {0, 500}});  // 400 + 300 + 250 + 250 + 500

/// One block in mm, all capitals, closed.
std::string closedFile() {
    return DxfBuilder()
        .section("BLOCKS")
        .block("front_M")
        .text("PIECE NAME: front")
        .text("SIZE: M")
        .text("QUANTITY: 1,1")
        .text("MATERIAL: wool: heavy")
        .polyline("1", kPanelOutline, true)
        .line("7", 50, 100, 50, 300)
        .point("4", 400, 100)
        .number(30, 5)
        .number(50, 180)
        .point("13", 200, 200)
        .number(30, 2)
        .polyline("11", lineThrough({{100, 100}, {120, 100}, {120, 120}}), true)
        .line("8", 10, 10, 20, 20)
        .endBlock()
        .end()
        .section("ENTITIES")
        .insert("front_M")
        .text("STYLE NAME: a dress")
        .text("SAMPLE SIZE: M")
        .text("UNITS: METRIC")
        .end()
        .take();
}

/// @param parts  of its outline, by pairs of points
std::string fileOfParts(const std::vector<Points2>& parts) {
    DxfBuilder text;
    text.section("BLOCKS").block("a");
    for (const Points2& part : parts) {
        text.polyline("1", part, false);
    }
    return text.endBlock().end().section("ENTITIES").text("Units: METRIC").end().take();
}

PatternFile readAll(const std::string& bytes, std::optional<LengthUnit> unit = {}) {
    auto file = readDxfPattern(bytes, unit);
    EXPECT_TRUE(file) << (file ? "" : sentence(file.error()));
    return file ? std::move(*file) : PatternFile{};
}

TEST(DxfPattern, ReadsAPieceWithAllThatIsOnIt) {
    const PatternFile file = readAll(closedFile());
    EXPECT_EQ(file.style, "a dress");
    EXPECT_EQ(file.sampleSize, "M");
    EXPECT_EQ(file.sizes, std::vector<std::string>{"M"});
    EXPECT_EQ(file.unit, LengthUnit::Millimetre);
    EXPECT_FALSE(file.unitInDoubt);
    ASSERT_EQ(file.pieces.size(), 1U);
    const FilePiece& piece = file.pieces.front();
    EXPECT_EQ(piece.id, "front_M");
    EXPECT_EQ(piece.name, "front");
    EXPECT_EQ(piece.size, "M");
    EXPECT_EQ(piece.material, "wool: heavy");
    EXPECT_EQ(piece.quantity, 1);
    EXPECT_EQ(piece.mirroredQuantity, 1);
    EXPECT_EQ(piece.cut, kPanelOutline);
    EXPECT_EQ(piece.sew.rows(), 0);
    EXPECT_DOUBLE_EQ(geometry::perimeterOf(piece.cut), 1700);
    EXPECT_DOUBLE_EQ(geometry::signedAreaOf(piece.cut), 400 * 300 + 0.5 * (400 + 250) * 200);
    ASSERT_TRUE(piece.grain);
    EXPECT_EQ((*piece.grain)[1], Eigen::Vector2d(50, 300));
    ASSERT_EQ(piece.notches.size(), 1U);
    EXPECT_NEAR(std::abs(*piece.notches.front().angle), kPi, 1e-12);
    EXPECT_EQ(piece.notches.front().depth, 5);
    ASSERT_EQ(piece.drills.size(), 1U);
    EXPECT_EQ(piece.drills.front().diameter, 2);
    ASSERT_EQ(piece.holes.size(), 1U);
    EXPECT_LT(geometry::signedAreaOf(piece.holes.front()), 0);
    EXPECT_EQ(piece.internals.size(), 1U);
    EXPECT_EQ(piece.layers.at("1"), 5);
}

TEST(DxfPattern, JoinsOpenLinesInAnyOrderAndDirection) {
    std::vector<Points2> parts{lineThrough({{0, 0}, {400, 0}}), lineThrough({{400, 0}, {400, 300}}),
                               lineThrough({{400, 300}, {250, 500}, {0, 500}}),
                               lineThrough({{0, 500}, {0, 0}})};
    std::mt19937 random(1);
    for (int trial = 0; trial < 20; ++trial) {
        std::shuffle(parts.begin(), parts.end(), random);
        for (Points2& part : parts) {
            part = random() % 2 == 0 ? part : Points2(part.colwise().reverse());
        }
        const PatternFile file = readAll(fileOfParts(parts));
        ASSERT_EQ(file.pieces.size(), 1U);
        EXPECT_EQ(file.pieces.front().cut.rows(), 5);
        EXPECT_NEAR(geometry::perimeterOf(file.pieces.front().cut), 1700, 1e-9);
        EXPECT_NEAR(geometry::signedAreaOf(file.pieces.front().cut),
                    geometry::signedAreaOf(kPanelOutline), 1e-6);
    }
}

TEST(DxfPattern, MakesHalvesWhole) {
    DxfBuilder text;
    text.section("BLOCKS")
        .block("back")
        .polyline("1", kPanelOutline, true)
        .line("6", 0, 0, 0, 500)
        .polyline("14", lineThrough({{0, 10}, {390, 10}, {390, 300}, {245, 490}, {0, 490}}), false)
        .point("4", 400, 100)
        .number(50, 180)
        .point("4", 0, 500)
        .line("8", 100, 100, 200, 100)
        .endBlock()
        .end()
        .section("ENTITIES")
        .end();
    const PatternFile file = readAll(text.take());
    ASSERT_EQ(file.pieces.size(), 1U);
    const FilePiece& piece = file.pieces.front();
    EXPECT_TRUE(piece.isUnfolded);
    EXPECT_NEAR(geometry::signedAreaOf(piece.cut), 2 * geometry::signedAreaOf(kPanelOutline), 1e-6);
    EXPECT_NEAR(geometry::perimeterOf(piece.cut), 2 * (1700 - 500), 1e-9);
    // The seam line is open where the fold is.
    EXPECT_NEAR(piece.sew.col(0).minCoeff(), -390, 1e-9);
    // That on the fold is there once.
    ASSERT_EQ(piece.notches.size(), 3U);
    EXPECT_EQ(piece.notches.back().point, Eigen::Vector2d(-400, 100));
    EXPECT_NEAR(std::remainder(*piece.notches.back().angle, 2 * kPi), 0, 1e-9);
    EXPECT_EQ(piece.internals.size(), 2U);
}

TEST(DxfPattern, LeavesAWholePieceWithAMirrorLineAsItIs) {
    DxfBuilder text;
    text.section("BLOCKS")
        .block("a")
        .polyline("1", kPanelOutline, true)
        .line("6", 200, 0, 200, 500)
        .endBlock()
        .end()
        .section("ENTITIES")
        .end();
    const PatternFile file = readAll(text.take());
    EXPECT_FALSE(file.pieces.front().isUnfolded);
    EXPECT_EQ(file.pieces.front().cut, kPanelOutline);
    EXPECT_EQ(file.notes.size(), 1U);
}

TEST(DxfPattern, TakesTheFinerOfALineAndItsQualityLine) {
    const Points2 fine = test::curvedPanel(200, 150);
    Points2 coarse(50, 2);
    for (Eigen::Index k = 0; k < 50; ++k) {
        coarse.row(k) = fine.row(4 * k);
    }
    for (const bool isSwapped : {false, true}) {
        DxfBuilder text;
        text.section("BLOCKS")
            .block("a")
            .polyline(isSwapped ? "84" : "1", coarse, true)
            .polyline(isSwapped ? "1" : "84", fine, true)
            .endBlock()
            .end()
            .section("ENTITIES")
            .end();
        const PatternFile file = readAll(text.take());
        EXPECT_NEAR(geometry::perimeterOf(file.pieces.front().cut), geometry::perimeterOf(fine),
                    1e-3);
    }
}

TEST(DxfPattern, PlacesBlocksAsTheyAreInserted) {
    DxfBuilder text;
    text.section("BLOCKS")
        .block("a", 10, 20)
        .polyline("1", kPanelOutline, true)
        .endBlock()
        .end()
        .section("ENTITIES")
        .insert("a", 100, 200)
        .number(50, 90)
        .end();
    const PatternFile file = readAll(text.take());
    // The base goes to the place of insertion; what is to its right lies above it.
    const Points2& cut = file.pieces.front().cut;
    EXPECT_NEAR(cut(0, 0), 100 + 20, 1e-9);
    EXPECT_NEAR(cut(0, 1), 200 - 10, 1e-9);
    EXPECT_NEAR(cut(1, 0), 100 + 20, 1e-9);
    EXPECT_NEAR(cut(1, 1), 200 + 390, 1e-9);
}

/// A square without blocks of texts.
std::string squareFile(double side, std::string_view units, const char* header = nullptr,
                       std::string_view more = {}) {
    DxfBuilder text;
    if (header) {
        text.section("HEADER").tag(9, "$INSUNITS").tag(70, header).end();
    }
    text.section("BLOCKS")
        .block("12")
        .text("Piece Name: FRONT")
        .text("Size: 38")
        .polyline("1", lineThrough({{0, 0}, {side, 0}, {side, side}, {0, side}}), true)
        .endBlock()
        .end()
        .section("ENTITIES");
    if (!more.empty()) {
        text.text(std::string(more));
    }
    if (!units.empty()) {
        text.text("Units: " + std::string(units));
    }
    return text.end().take();
}

TEST(DxfPattern, JudgesTheUnitByWhatItSaysAndByTheSize) {
    const struct {
        double side;
        const char *units, *header;
        LengthUnit unit;
        bool inDoubt;
    } cases[] = {{600, "METRIC", nullptr, LengthUnit::Millimetre, false},
                 {100, "METRIC", nullptr, LengthUnit::Centimetre, true},
                 {100, "METRIC", "4", LengthUnit::Millimetre, true},
                 {40, "METRIC", nullptr, LengthUnit::Centimetre, true},
                 {24, "ENGLISH", nullptr, LengthUnit::Inch, false},
                 {118, "english", nullptr, LengthUnit::Inch, true},
                 {600, "ENGLISH", nullptr, LengthUnit::Millimetre, true},
                 {600, "", "4", LengthUnit::Millimetre, false},
                 {60, "", "5", LengthUnit::Centimetre, false},
                 {30, "", "6", LengthUnit::Centimetre, true},
                 {0.6, "", nullptr, LengthUnit::Metre, true},
                 {60, "", nullptr, LengthUnit::Centimetre, true}};
    for (const auto& [side, units, header, unit, inDoubt] : cases) {
        const PatternFile file = readAll(squareFile(side, units, header));
        EXPECT_EQ(file.unit, unit) << side << units;
        EXPECT_EQ(file.unitInDoubt, inDoubt) << side << units;
        EXPECT_FALSE(file.unitReason.empty());
        EXPECT_EQ(file.pieces.front().name, "FRONT");
        EXPECT_NEAR(geometry::perimeterOf(file.pieces.front().cut), 4 * side * millimetresPer(unit),
                    1e-3);
    }
    const std::string metric = squareFile(100, "METRIC"), text = "Units: METRIC";
    for (const LengthUnit unit : {LengthUnit::Millimetre, LengthUnit::Centimetre}) {
        std::string own = metric;  // as Toile writes it
        own.replace(own.find(text), text.size(), "Unit: " + std::string(symbol(unit)));
        EXPECT_EQ(readAll(own).unit, unit);
    }
    // Another program's text of this name.
    EXPECT_EQ(readAll(squareFile(24, "ENGLISH", nullptr, "Unit: pcs")).unit, LengthUnit::Inch);
    const PatternFile stated = readAll(squareFile(600, "METRIC"), LengthUnit::Inch);
    EXPECT_NEAR(geometry::perimeterOf(stated.pieces.front().cut), 4 * 600 * 25.4, 1e-6);
    EXPECT_FALSE(stated.unitInDoubt);
}

TEST(DxfPattern, KnowsTheSampleSize) {
    DxfBuilder text;
    text.section("BLOCKS");
    for (const char* size : {"36", "38", "40"}) {
        text.block(std::string("front_") + size)
            .text("Piece Name: front")
            .text(std::string("Size: ") + size)
            .polyline("1", kPanelOutline, true);
        if (size == std::string("38")) {
            text.text("Material: 2").text("Quantity: 4");
        }
        text.endBlock();
    }
    text.end().section("ENTITIES").text("Sample Size: 38").end();
    const PatternFile file = readAll(text.take());
    EXPECT_EQ(file.sizes, (std::vector<std::string>{"36", "38", "40"}));
    EXPECT_EQ(sampleOf(file), std::vector<int>{1});
    EXPECT_EQ(file.pieces[2].quantity, 4);  // said of one size, meant of all
}

TEST(DxfPattern, ReadsOurOwnDrawing) {
    const Drawing drawing = test::sewingDrawing();
    const PatternFile file = readAll(writePlainDxf(drawing));
    EXPECT_EQ(file.unit, LengthUnit::Millimetre);
    ASSERT_EQ(file.pieces.size(), drawing.blocks.size());
    std::vector<double> is, should;
    for (const FilePiece& piece : file.pieces) {
        is.push_back(geometry::perimeterOf(piece.cut));
        EXPECT_FALSE(piece.name.empty());
    }
    for (const DrawnBlock& block : drawing.blocks) {
        should.push_back(geometry::perimeterOf(drawing.paths[block.path].points));
    }
    std::ranges::sort(is);
    std::ranges::sort(should);
    for (std::size_t k = 0; k < is.size(); ++k) {
        EXPECT_NEAR(is[k], should[k], 0.01);
    }
}

TEST(DxfPattern, RefusesWhatHasNoPieces) {
    const auto file =
        readDxfPattern(DxfBuilder().section("ENTITIES").line("1", 0, 0, 1, 1).end().take());
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().code, ErrorCode::NoGeometry);
    EXPECT_NE(file.error().detail.pattern(), nullptr);  // in other languages too
    EXPECT_FALSE(readDxfPattern("nothing"));
}

TEST(DxfPattern, SurvivesWhateverIsChanged) {
    const std::string whole = closedFile() + fileOfParts({kPanelOutline});
    std::mt19937 random(7);
    for (int trial = 0; trial < 3000; ++trial) {
        std::string bytes = whole;
        for (int change = 0; change < 3; ++change) {
            bytes[random() % bytes.size()] = "0123456789-.\n\re"[random() % 15];
        }
        bytes.resize(trial % 3 == 0 ? random() % bytes.size() : bytes.size());
        const auto file = readDxfPattern(bytes);
        for (const FilePiece& piece : file ? file->pieces : std::vector<FilePiece>{}) {
            EXPECT_TRUE(outlineOf(piece).allFinite());
            EXPECT_GT(std::abs(geometry::signedAreaOf(outlineOf(piece))), 0);
        }
    }
}

TEST(DxfPattern, ReadsThePatternsOfOtherPrograms) {
    const struct {
        const char* name;
        std::size_t pieces, sizes, sample;
        bool isUnfolded;
    } files[] = {{"clo-box", 1, 1, 1, false},
                 {"clo-pattern", 9, 1, 9, false},
                 {"men_classic_tee_aama", 105, 15, 7, true},
                 {"graded_a_aama", 42, 14, 3, false},
                 {"graded_a_astm", 42, 14, 3, false},
                 {"with_sewline_aama", 56, 14, 4, true},
                 {"skirt_clo", 4, 1, 4, false}};
    for (const auto& [name, pieces, sizes, sample, isUnfolded] : files) {
        const auto path = test::dataFile("patterns/" + std::string(name) + ".dxf");
        TOILE_NEEDS_SHARED(path);
        const auto bytes = readFile(path);
        ASSERT_TRUE(bytes);
        const PatternFile file = readAll(*bytes);
        EXPECT_EQ(file.pieces.size(), pieces) << name;
        EXPECT_EQ(file.sizes.size(), sizes) << name;
        EXPECT_EQ(sampleOf(file).size(), sample) << name;
        EXPECT_EQ(std::ranges::any_of(file.pieces, &FilePiece::isUnfolded), isUnfolded) << name;
        for (const FilePiece& piece : file.pieces) {
            EXPECT_TRUE(piece.grain) << name << ' ' << piece.name;
        }
    }
}

TEST(DxfPattern, FindsTheSameInBothFormsOfAStyle) {
    const auto path = test::dataFile("patterns/graded_a_aama.dxf"),
               other = test::dataFile("patterns/graded_a_astm.dxf");
    TOILE_NEEDS_SHARED(path);
    TOILE_NEEDS_SHARED(other);
    const PatternFile aama = readAll(*readFile(path)), astm = readAll(*readFile(other));
    ASSERT_EQ(aama.pieces.size(), astm.pieces.size());
    for (std::size_t k = 0; k < aama.pieces.size(); ++k) {
        EXPECT_EQ(aama.pieces[k].id, astm.pieces[k].id);
        const double coarse = geometry::perimeterOf(aama.pieces[k].cut);
        EXPECT_NEAR(geometry::perimeterOf(astm.pieces[k].cut), coarse, 2e-3 * coarse);
    }
}

TEST(DxfPattern, MirrorsNoInternalLineBesideNm) {
    for (const bool isMarked : {false, true}) {
        DxfBuilder text;
        text.section("BLOCKS").block("a");
        text.polyline("1", kPanelOutline, true).line("6", 0, 0, 0, 500);
        text.line("8", 50, 50, 80, 50).line("8", 200, 300, 250, 300);
        if (isMarked) {
            text.tag(0, "TEXT").tag(8, "8").at(60, 55).tag(1, " nm ");
        }
        const PatternFile file =
            readAll(text.endBlock().end().section("ENTITIES").text("Units: METRIC").end().take());
        ASSERT_EQ(file.pieces.size(), 1U);
        ASSERT_TRUE(file.pieces.front().isUnfolded);
        EXPECT_EQ(file.pieces.front().internals.size(), isMarked ? 3U : 4U);
    }
}

/// As Optitex writes it: bare numbers as names of blocks, one per size, Title Case.
std::string optitexFile(double unit, std::string_view insUnits, std::string_view units) {
    DxfBuilder text;
    text.section("HEADER").tag(9, "$INSUNITS").tag(70, insUnits).end().section("BLOCKS");
    int number = 0;
    for (const char* size : {"38", "40"}) {
        ++number;
        text.block(std::to_string(number)).text("Piece Name: Front");
        text.text("Size: " + std::string(size)).text("Annotation: shell").text("Quantity: 2,0");
        text.polyline("1", kPanelOutline * (unit * (1 + 0.05 * number)), true).endBlock();
    }
    text.end().section("ENTITIES").insert("1").insert("2").text("Author: Optitex;PDS;21");
    text.text("Style Name: s").text("Sample Size: 40");
    if (!units.empty()) {
        text.text("Units: " + std::string(units));
    }
    return text.end().take();
}

TEST(DxfPattern, SaysThatARuleTableBesideItIsNotRead) {
    const test::TemporaryFolder folder;
    const auto path = folder.write("a.dxf", squareFile(600, "METRIC"));
    const auto alone = readPatternFile(path);
    ASSERT_TRUE(alone);
    EXPECT_TRUE(alone->notes.empty());
    folder.write("a.rul", "Size List: 36 38\r\n");
    const auto graded = readPatternFile(path);
    ASSERT_TRUE(graded);
    ASSERT_EQ(graded->notes.size(), 1U);
    EXPECT_NE(std::string(graded->notes.front()).find("\"a.rul\""), std::string::npos);
}

TEST(DxfPattern, ReadsANestOfOptitexInCentimetresThatSaysMetric) {
    const PatternFile file = readAll(optitexFile(0.1, "0", "METRIC"));
    EXPECT_EQ(file.format, "DXF of Optitex (AAMA)");
    EXPECT_EQ(file.unit, LengthUnit::Centimetre);
    EXPECT_TRUE(file.unitInDoubt);
    EXPECT_EQ(file.sizes, (std::vector<std::string>{"38", "40"}));
    ASSERT_EQ(file.pieces.size(), 2U);
    EXPECT_EQ(file.pieces[1].name, "Front");
    EXPECT_EQ(file.pieces[1].id, "2");
    EXPECT_EQ(file.pieces[1].quantity, 2);
    EXPECT_EQ(sampleOf(file), std::vector<int>{1});
    EXPECT_NEAR(geometry::perimeterOf(file.pieces[1].cut),
                1.1 * geometry::perimeterOf(kPanelOutline), 0.01);
}

TEST(DxfPattern, DoubtsMetresOfOptitexOverInchesAndTakesAPersonsWord) {
    const std::string bytes = optitexFile(1 / 25.4, "6", "");
    EXPECT_TRUE(readAll(bytes).unitInDoubt);
    EXPECT_NE(readAll(bytes).unit, LengthUnit::Metre);
    const PatternFile file = readAll(bytes, LengthUnit::Inch);
    ASSERT_EQ(file.pieces.size(), 2U);
    EXPECT_FALSE(file.unitInDoubt);
    EXPECT_NEAR(geometry::perimeterOf(file.pieces[0].cut),
                1.05 * geometry::perimeterOf(kPanelOutline), 0.01);
}

TEST(DxfPattern, LeavesOutWhatIsNowhere) {
    DxfBuilder text;
    text.section("BLOCKS").block("a").polyline("1", kPanelOutline, true);
    for (const char* layer : {"4", "13"}) {
        text.tag(0, "POINT").tag(8, layer).tag(10, "1e308").tag(20, "5");
        text.point(layer, 50, 50).tag(30, "1e308");
    }
    text.tag(0, "LINE").tag(8, "7").tag(10, "-1e308").tag(20, "0").tag(11, "1e308").tag(21, "5");
    const PatternFile file =
        readAll(text.endBlock().end().section("ENTITIES").text("Units: ENGLISH").end().take());
    ASSERT_EQ(file.pieces.size(), 1U);
    const FilePiece& piece = file.pieces.front();
    ASSERT_EQ(piece.notches.size(), 1U);
    EXPECT_FALSE(piece.notches.front().depth);
    ASSERT_EQ(piece.drills.size(), 1U);
    EXPECT_FALSE(piece.drills.front().diameter);
    EXPECT_FALSE(piece.grain);
}

Points2 rectangleFrom(double x, double y, double width, double height) {
    return lineThrough({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
}

bool hasNote(const PatternFile& file, std::string_view words) {
    return std::ranges::any_of(
        file.notes, [words](const Wording& note) { return note.find(words) != std::string::npos; });
}

/// Closed lines on a sheet, in mm, each with its layer.
std::string sheetFile(const std::vector<std::pair<const char*, Points2>>& lines) {
    DxfBuilder text;
    text.section("HEADER").tag(9, "$INSUNITS").tag(70, "4").end().section("ENTITIES");
    for (const auto& [layer, line] : lines) {
        text.polyline(layer, line, true);
    }
    return text.end().take();
}

TEST(DxfPattern, LeavesTheBorderOfASheetOut) {
    const Points2 front = kPanelOutline.rowwise() + Eigen::RowVector2d(60, 60);
    const Points2 back = kPanelOutline.rowwise() + Eigen::RowVector2d(600, 60);
    const Points2 border = rectangleFrom(0, 0, 1189, 841);
    const Points2 margin = rectangleFrom(10, 10, 1169, 821);
    const Points2 title = rectangleFrom(1000, 10, 179, 50);
    for (const char* layer : {"0", "FRAME"}) {
        const PatternFile file = readAll(sheetFile(
            {{"0", front}, {layer, border}, {"0", back}, {layer, margin}, {layer, title}}));
        ASSERT_EQ(file.pieces.size(), 2u) << layer;
        for (const FilePiece& piece : file.pieces) {
            EXPECT_NEAR(geometry::perimeterOf(piece.cut), 1700, 1e-6);
            EXPECT_TRUE(piece.holes.empty());
        }
        EXPECT_TRUE(hasNote(file, "the border of the sheet is left out"));
    }
    // A border of lines in a block of its own.
    DxfBuilder text;
    text.section("BLOCKS").block("sheet").line("0", 0, 0, 1189, 0).line("0", 1189, 0, 1189, 841);
    text.line("0", 1189, 841, 0, 841).line("0", 0, 841, 0, 0).endBlock().end();
    text.section("ENTITIES").tag(0, "INSERT").tag(8, "0").tag(2, "sheet").at(0, 0);
    text.polyline("0", front, true).polyline("0", back, true);
    EXPECT_EQ(readAll(text.end().take(), LengthUnit::Millimetre).pieces.size(), 2u);
}

TEST(DxfPattern, APieceWithHolesIsNoBorder) {
    const PatternFile patch = readAll(sheetFile({{"0", rectangleFrom(0, 0, 200, 160)},
                                                 {"0", rectangleFrom(20, 20, 12, 2)},
                                                 {"0", rectangleFrom(60, 20, 12, 2)}}));
    ASSERT_EQ(patch.pieces.size(), 1u);
    EXPECT_EQ(patch.pieces[0].holes.size(), 2u);
    EXPECT_TRUE(patch.notes.empty());
    // One large hole of a rectangle may be a piece.
    const PatternFile doubtful =
        readAll(sheetFile({{"0", rectangleFrom(0, 0, 600, 500)}, {"0", kPanelOutline * 0.5}}));
    ASSERT_EQ(doubtful.pieces.size(), 1u);
    EXPECT_TRUE(hasNote(doubtful, "check piece 1: it has 1 hole"));
    // One so large may be the seam line in the line that is cut along, with a name in it.
    DxfBuilder text;
    text.section("ENTITIES").polyline("0", rectangleFrom(-20, -20, 440, 340), true);
    text.polyline("0", rectangleFrom(-10, -10, 420, 320), true).text("front", "0").end();
    EXPECT_NEAR(geometry::signedAreaOf(readAll(text.take()).pieces.at(0).cut), 440 * 340, 1e-6);
}

TEST(DxfPattern, CountsWhatItLeavesOut) {
    DxfBuilder text;
    text.section("HEADER").tag(9, "$INSUNITS").tag(70, "4").end().section("ENTITIES");
    text.polyline("CUT", kPanelOutline, true).line("SKETCH", 10, 10, 20, 20);
    text.line("CUT", 900, 0, 950, 0).line("INTERNAL", 900, 0, 950, 0);
    text.tag(0, "HATCH").tag(8, "CUT").tag(0, "HATCH").tag(8, "CUT").insert("nowhere");
    text.tag(0, "CIRCLE").tag(8, "0").tag(67, "1").at(0, 0).number(40, 300);
    const PatternFile file = readAll(text.end().take());
    EXPECT_EQ(file.pieces.size(), 1u);
    EXPECT_TRUE(hasNote(file, "does not read them: 2 HATCH, 1 INSERT of a block that is not"));
    EXPECT_TRUE(hasNote(file, "does not use their layers: 1 LINE (layer SKETCH)"));
    EXPECT_TRUE(hasNote(file, "belong to no piece: 1 LINE"));
    EXPECT_TRUE(hasNote(file, "not closed: 1 line"));
    EXPECT_TRUE(hasNote(file, "paper space): 1"));
}

TEST(DxfPattern, SaysWhatLiesBesideItsBlocks) {
    DxfBuilder text;
    text.section("BLOCKS").block("a").text("Piece Name: front").polyline("1", kPanelOutline, true);
    text.polyline("1", rectangleFrom(1000, 0, 50, 50), true).line("99", 0, 0, 1, 1).endBlock();
    text.end().section("ENTITIES").insert("a").insert("a").line("1", 0, 0, 9, 9);
    const PatternFile file = readAll(text.text("Units: METRIC").end().take());
    ASSERT_EQ(file.pieces.size(), 1u);
    EXPECT_TRUE(file.pieces[0].holes.empty());
    EXPECT_TRUE(hasNote(file, "outside its outline: 1 closed line"));
    EXPECT_TRUE(hasNote(file, "each block once: 1 INSERT of a"));
    EXPECT_TRUE(hasNote(file, "belong to no piece: 1 LINE"));
    EXPECT_TRUE(hasNote(file, "1 LINE (layer 99)"));
}

TEST(DxfPattern, CountsInsertsOfExternalAndMissingBlocks) {
    for (const bool isNamed : {false, true}) {  // a drawing; blocks that are pieces
        DxfBuilder text;
        text.section("BLOCKS").block("front");
        text.text(isNamed ? "Piece Name: front" : "front").polyline("1", kPanelOutline, true);
        text.endBlock().tag(0, "BLOCK").tag(8, "0").tag(2, "lining").tag(70, "4").at(0, 0);
        text.tag(1, "lining.dwg").endBlock().end().section("ENTITIES").insert("front");
        const PatternFile file = readAll(text.insert("lining").insert("gone").end().take());
        EXPECT_EQ(file.pieces.size(), 1U);
        ASSERT_EQ(file.notes.size(), 1U) << file.notes.back();
        EXPECT_TRUE(hasNote(file, "them: 2 INSERT of a block that is not in the file"));
    }
}

TEST(DxfPattern, HasOneNotePerKindHoweverManyThereAre) {
    constexpr int kCount = 5000;
    DxfBuilder text;
    text.section("BLOCKS").block("a").text("Piece Name: front").polyline("1", kPanelOutline, true);
    text.endBlock();
    for (int k = 0; k < kCount; ++k) {
        text.block("b" + std::to_string(k)).line("1", 0, 0, 1, 1).endBlock();
    }
    text.end().section("ENTITIES");
    for (int k = 0; k <= kCount; ++k) {
        text.insert("a");
    }
    const auto file = readPattern(text.end().take(), PatternFileKind::Dxf, "a.dxf");
    ASSERT_TRUE(file);
    EXPECT_EQ(file->pieces.size(), 1U);
    EXPECT_TRUE(hasNote(*file, "each block once: 5000 INSERT of a"));
    EXPECT_TRUE(hasNote(*file, "4990 more notes like: b10 is left out"));
    EXPECT_LT(file->notes.size(), 30U);
}

TEST(DxfPattern, RefusesCurvesOfTooManyPoints) {
    const auto read = [](int count, double radius) {
        DxfBuilder text;
        text.section("ENTITIES");
        for (int k = 0; k < count; ++k) {
            text.tag(0, "CIRCLE").tag(8, "CUT").at(k, 0).number(40, radius);
        }
        return readPattern(text.end().take(), PatternFileKind::Dxf, "circles.dxf",
                           FileUnit(LengthUnit::Millimetre));
    };
    const auto many = read(20000, 1e7);  // 10 km: 32 768 points each
    ASSERT_FALSE(many);
    const std::string why = sentence(many.error());
    for (const char* part : {"circles.dxf", "more than 5000000 points", "check the unit"}) {
        EXPECT_NE(why.find(part), std::string::npos) << why;
    }
    EXPECT_TRUE(read(3, 1e7));
    EXPECT_TRUE(read(5000, 1.5));  // punched holes
}

TEST(DxfPattern, CopiesOfBlocksAreBoundedInTheWholeFile) {
    DxfBuilder text;
    text.section("BLOCKS").block("a").text("Piece Name: front").polyline("1", kPanelOutline, true);
    text.endBlock();
    for (int k = 0; k < 1000; ++k) {
        text.block("b" + std::to_string(k)).insert("a").tag(70, "500").tag(71, "500").endBlock();
    }
    const PatternFile file = readAll(text.end().section("ENTITIES").insert("a").end().take());
    EXPECT_GE(file.pieces.size(), 1U);
    EXPECT_TRUE(hasNote(file, "does not read them: 1000 INSERT"));
}

TEST(DxfPattern, BlocksThatInsertThemselvesEnd) {
    DxfBuilder text;
    text.section("BLOCKS").block("a").insert("a").tag(70, "500").tag(71, "500").insert("a");
    text.endBlock().end().section("ENTITIES").insert("a").polyline("0", kPanelOutline, true);
    EXPECT_EQ(readAll(text.end().take()).pieces.size(), 1u);
}

}  // namespace
}  // namespace toile
