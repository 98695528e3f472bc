// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/dxf/apparel_dxf.h"

#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "core/formats/dxf/apparel_pieces.h"
#include "tests/core/formats/dxf_reader.h"
#include "tests/core/formats/export_fixtures.h"
#include "tests/core/formats/exported_garments.h"
#include "tests/core/readers/dxf_drawing.h"

namespace toile {
namespace {

constexpr DxfProfile kProfiles[] = {DxfProfile::Astm, DxfProfile::Aama};

std::set<std::string> layersOf(const DxfGroupOfEntities& block) {
    std::set<std::string> layers;
    for (const auto& line : block.polylines) {
        layers.emplace(line.layer);
    }
    for (const auto& line : block.lines) {
        layers.emplace(line.layer);
    }
    for (const auto& record : block.records) {
        layers.emplace(record.layer);
    }
    return layers;
}

TEST(ApparelDxf, IsBareR12WithOneBlockForEachPiece) {
    for (const DxfProfile profile : kProfiles) {
        const test::ExportedGarment made = test::markedPieces();
        const std::string bytes = test::dxfOf(made, test::dxfOptions(profile));
        const test::DxfFile file(bytes);
        EXPECT_TRUE(file.faults.empty()) << file.faults.front();
        EXPECT_TRUE(file.header.empty());
        EXPECT_TRUE(file.layers.empty());
        EXPECT_EQ(bytes.find("TABLES"), std::string::npos);
        EXPECT_EQ(static_cast<std::size_t>(file.blocks), made.laid.marker.copies.size());
        const auto document = readDxfDocument(bytes);
        ASSERT_TRUE(document);
        const DxfDrawing read = dxfDrawing(*document, 1);
        ASSERT_EQ(read.page.inserts.size(), read.blocks.size());
        for (std::size_t k = 0; k < read.blocks.size(); ++k) {
            EXPECT_EQ(read.page.inserts[k].first, read.blocks[k].name);
            EXPECT_EQ(read.page.inserts[k].second, Eigen::Vector2d(0, 0));
        }
    }
}

TEST(ApparelDxf, HasTheLayersOfItsProfile) {
    const test::ExportedGarment made = test::markedPieces(NotchForm::T);
    const std::string astm = test::dxfOf(made, test::dxfOptions(DxfProfile::Astm));
    const std::string aama = test::dxfOf(made, test::dxfOptions(DxfProfile::Aama));
    const auto first = [](const std::string& bytes) {
        return layersOf(dxfDrawing(*readDxfDocument(bytes), 1).blocks.front());
    };
    EXPECT_EQ(first(astm),
              (std::set<std::string>{"1", "11", "13", "2", "3", "7", "8", "80", "84", "85", "86"}));
    EXPECT_EQ(first(aama), (std::set<std::string>{"1", "11", "13", "2", "3", "4", "7", "8"}));
    const test::ExportedGarment shirt = test::exported("samples/tshirt.obj", true);
    EXPECT_EQ(first(test::dxfOf(shirt, test::dxfOptions(DxfProfile::Astm))),
              (std::set<std::string>{"1", "14", "2", "3", "4", "7", "84", "87"}));
}

TEST(ApparelDxf, SaysWhichNotchAndWhichWay) {
    const struct {
        NotchForm form;
        const char *astm, *aama;
        bool hasWidth, hasWidthInAama;
    } forms[] = {{NotchForm::Slit, "4", "4", false, false},
                 {NotchForm::V, "4", "4", true, true},
                 {NotchForm::T, "80", "4", true, false},
                 {NotchForm::Castle, "81", "4", true, false}};
    for (const auto& [form, astm, aama, hasWidth, hasWidthInAama] : forms) {
        const test::ExportedGarment made = test::markedPieces(form);
        for (const DxfProfile profile : kProfiles) {
            const bool isAstm = profile == DxfProfile::Astm;
            const std::string bytes =
                test::dxfOf(made, test::dxfOptions(profile, LengthUnit::Centimetre));
            const DxfDrawing read = dxfDrawing(*readDxfDocument(bytes), 10);
            int count = 0;
            for (const DxfRecord& record : read.blocks.front().records) {
                if (record.layer != (isAstm ? astm : aama)) {
                    continue;
                }
                EXPECT_EQ(record.width.has_value(), isAstm ? hasWidth : hasWidthInAama);
                EXPECT_NEAR(record.width.value_or(5), 5, 1e-3);
                EXPECT_NEAR(record.height.value_or(0), 5, 1e-3);
                EXPECT_TRUE(record.angle);
                ++count;
            }
            EXPECT_EQ(count, 4);  // one of them is double
        }
    }
}

TEST(ApparelDxf, BeginsPrimaryAndValidationAtTheSamePoint) {
    const std::string bytes =
        test::dxfOf(test::exported("samples/bodice.obj", true), test::dxfOptions(DxfProfile::Astm));
    const DxfDrawing read = dxfDrawing(*readDxfDocument(bytes), 1);
    for (const DxfGroupOfEntities& block : read.blocks) {
        ASSERT_EQ(block.polylines.size() % 2, 0U);
        for (std::size_t k = 0; k < block.polylines.size(); k += 2) {
            const DxfLine &primary = block.polylines[k], &dense = block.polylines[k + 1];
            EXPECT_EQ(dense.layer,
                      std::to_string(validationLayer(std::stoi(std::string(primary.layer)))));
            EXPECT_EQ(dense.closed, primary.closed);
            Eigen::Index next = 0;  // the key points are among its own, in their order
            for (Eigen::Index row = 0; row < dense.points.rows(); ++row) {
                next += next < primary.points.rows() &&
                        dense.points.row(row) == primary.points.row(next);
            }
            EXPECT_EQ(next, primary.points.rows());
            EXPECT_EQ(dense.points.row(0), primary.points.row(0));
        }
    }
}

TEST(ApparelDxf, NamesPiecesInCapitalsOfAscii) {
    EXPECT_EQ(apparelName("Ärmel <links> & \"rechts\"", "aermel"), "ARMEL_LINKS_RECHTS");
    EXPECT_EQ(apparelName("前身頃", "piece-2"), "PIECE-2");
    EXPECT_EQ(apparelName("a name that is far too long for them", "x"), "A_NAME_THAT_IS_FAR_T");
    EXPECT_EQ(apparelName("", ""), "PIECE");
    EXPECT_EQ(apparelName("***", "!"), "PIECE");
    Pattern pattern = test::sewingPattern();
    for (PatternPiece& piece : pattern.pieces) {
        piece.name = "the very same name of all";
    }
    pattern.pieces.back().name = "Control";
    const std::string bytes =
        test::dxfOf(test::exported(pattern), test::dxfOptions(DxfProfile::Aama));
    std::vector<std::string> names;
    const auto document = readDxfDocument(bytes);
    ASSERT_TRUE(document);
    for (const DxfBlock& block : document->blocks) {
        names.emplace_back(block.name);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"THE_VERY_SAME_NAME_O", "THE_VERY_SAME_NAME-2",
                                               "THE_VERY_SAME_NAME-3", "CONTROL-2"}));
}

TEST(ApparelDxf, NumbersPiecesWithoutLatinLettersAndSaysSo) {
    Pattern pattern = test::sewingPattern();
    const char* names[] = {"前片", "Перед", "كم", "back"};
    for (std::size_t k = 0; k < 4; ++k) {
        pattern.pieces[k].name = names[k];
        pattern.pieces[k].slug = "piece-" + std::to_string(9 - k);
        pattern.pieces[k].number = static_cast<int>(k) + 1;
    }
    const test::ExportedGarment made = test::exported(pattern);
    const ExportOptions options = test::dxfOptions(DxfProfile::Astm);
    const std::string bytes = test::dxfOf(made, options);
    const auto document = readDxfDocument(bytes);
    ASSERT_TRUE(document);
    std::vector<std::string> written;
    for (const DxfBlock& block : document->blocks) {
        written.emplace_back(block.name);
    }
    EXPECT_EQ(written, (std::vector<std::string>{"PIECE-1", "PERED", "PIECE-3", "BACK"}));
    EXPECT_EQ(bytes.find("___"), std::string::npos);  // labels too
    const auto notes = renamedNotes(made.source(options));
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(
        std::string(notes.front()).find("\"前片 = PIECE-1\", \"Перед = PERED\", \"كم = PIECE-3\""),
        std::string::npos)
        << std::string(notes.front());
}

TEST(ApparelDxf, SaysHowOftenAPieceIsCut) {
    Pattern pattern = test::sewingPattern();
    pattern.label = {"38 / M", "3 May"};
    pattern.pieces[0].quantity = 3;
    pattern.pieces[1].mirroredPair = true;
    pattern.pieces[2].quantity = 2;
    pattern.pieces[3].material = "Futter";
    test::ExportedGarment made = test::exported(pattern);
    made.laid.pattern.pieces[2].cutAs = CutAs::Pair;
    made.laid.marker.copies[0].placement.mirrored = true;
    const std::string bytes =
        test::dxfOf(made, test::dxfOptions(DxfProfile::Astm, LengthUnit::Inch));
    const DxfDrawing read = dxfDrawing(*readDxfDocument(bytes), 25.4);
    const char* quantities[] = {"0,3", "1,1", "2,2", "1,0"};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto& said = read.blocks[k].said;
        EXPECT_EQ(said.at("quantity"), quantities[k]);
        EXPECT_EQ(said.at("size"), "38_M");
        EXPECT_EQ(said.at("material"), k == 3 ? "Futter" : "");
        for (const char* key : {"piece name", "annotation", "category"}) {
            EXPECT_TRUE(said.contains(key)) << key;
        }
    }
    EXPECT_EQ(read.page.said.at("units"), "ENGLISH");
    EXPECT_EQ(read.page.said.at("creation date"), "3 May");
    EXPECT_EQ(read.page.said.at("sample size"), "38_M");
    EXPECT_EQ(read.page.said.at("style name"), "GROSSE_38_PROBE");
    EXPECT_EQ(read.page.said.at("astm/d13 proposal 1 version"), "D6673-10");
    for (const char* key : {"author", "creation time", "grade rule table", "curve tolerance"}) {
        EXPECT_TRUE(read.page.said.contains(key)) << key;
    }
}

TEST(ApparelDxf, DrawsHalvesToTheirMirrorLine) {
    test::ExportedGarment made = test::exported("samples/tshirt.obj", true);
    test::cutByHalf(made);
    const std::string bytes = test::dxfOf(made, test::dxfOptions(DxfProfile::Aama));
    const DxfDrawing read = dxfDrawing(*readDxfDocument(bytes), 1);
    int halves = 0;
    ASSERT_EQ(read.blocks.size(), made.laid.marker.copies.size());
    for (std::size_t k = 0; k < read.blocks.size(); ++k) {
        const auto index = static_cast<std::size_t>(made.laid.marker.copies[k].piece);
        const bool isHalf = made.laid.pattern.pieces[index].cutAs == CutAs::OnFold;
        EXPECT_EQ(read.blocks[k].said.contains("fold"), isHalf);
        EXPECT_EQ(std::ranges::count(read.blocks[k].lines, "6", &DxfLine::layer), isHalf ? 1 : 0);
        halves += isHalf ? 1 : 0;
    }
    EXPECT_GT(halves, 0);
}

TEST(ApparelDxf, GivesTheSameBytesTwiceAndInAnyLocale) {
    for (const DxfProfile profile : kProfiles) {
        ExportOptions options = test::dxfOptions(profile, LengthUnit::Inch);
        options.dxf.controlPiece = options.dxf.ruleTable = true;
        const std::string bytes = test::dxfOf(test::markedPieces(), options);
        EXPECT_EQ(bytes, test::dxfOf(test::markedPieces(), options));
        const test::CommaLocale comma;
        EXPECT_EQ(bytes, test::dxfOf(test::markedPieces(), options));
    }
}

TEST(ApparelDxf, MeasuresTheSameInEachUnit) {
    const test::ExportedGarment made = test::markedPieces();
    const std::string mm = test::dxfOf(made, test::dxfOptions(DxfProfile::Astm));
    const auto document = readDxfDocument(mm);
    const DxfDrawing expected = dxfDrawing(*document, 1);
    for (const LengthUnit unit : {LengthUnit::Centimetre, LengthUnit::Inch}) {
        const std::string bytes = test::dxfOf(made, test::dxfOptions(DxfProfile::Astm, unit));
        const DxfDrawing read = dxfDrawing(*readDxfDocument(bytes), millimetresPer(unit));
        for (std::size_t k = 0; k < read.blocks.size(); ++k) {
            ASSERT_EQ(read.blocks[k].polylines.size(), expected.blocks[k].polylines.size());
            for (std::size_t p = 0; p < read.blocks[k].polylines.size(); ++p) {
                const Points2 error =
                    read.blocks[k].polylines[p].points - expected.blocks[k].polylines[p].points;
                EXPECT_LT(error.cwiseAbs().maxCoeff(), 5e-4);
            }
        }
    }
}

TEST(ApparelDxf, HasARuleTableAndAControlPieceOnRequest) {
    const test::ExportedGarment made = test::exported(test::sewingPattern());
    ExportOptions options = test::dxfOptions(DxfProfile::Astm);
    const auto write = formatOf(FormatId::Dxf).write;
    EXPECT_EQ(write(made.source(options))->size(), 1U);
    options.dxf.ruleTable = options.dxf.controlPiece = true;
    const auto files = write(made.source(options));
    ASSERT_TRUE(files);
    ASSERT_EQ(files->size(), 2U);
    EXPECT_EQ(files->back().beside, ".rul");
    EXPECT_NE(files->back().bytes.find("Number of Sizes: 1\r\n"), std::string::npos);
    const DxfDrawing read = dxfDrawing(*readDxfDocument(files->front().bytes), 1);
    ASSERT_EQ(read.blocks.size(), 5U);
    const DxfGroupOfEntities& control = read.blocks.back();
    EXPECT_EQ(control.name, "CONTROL");
    EXPECT_EQ(control.said.at("category"), "DO NOT CUT");
    EXPECT_EQ(test::edgeLengths(control.polylines.front().points),
              Eigen::VectorXd::Constant(4, 100));
    EXPECT_EQ(read.page.said.at("grade rule table"), read.page.said.at("style name"));
}

TEST(ApparelDxf, OfNothingHasNoBlocks) {
    const test::ExportedGarment made = test::exported(Pattern{});
    for (const DxfProfile profile : kProfiles) {
        const std::string bytes = test::dxfOf(made, test::dxfOptions(profile));
        EXPECT_TRUE(test::DxfFile(bytes).faults.empty());
        const auto back =
            formatOf(FormatId::Dxf).readBack({{"", bytes}}, made.source(test::dxfOptions(profile)));
        EXPECT_TRUE(back) << sentence(back.error());
    }
}

}  // namespace
}  // namespace toile
