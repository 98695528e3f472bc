// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/base/version.h"
#include "core/formats/writers.h"
#include "tests/core/formats/export_fixtures.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

using Json = nlohmann::json;

Json report(const test::GarmentAndResults& all) {
    return Json::parse(writeReport(all.garment, all.results));
}

TEST(WriteReport, NamesItsVersionFilesAndPieces) {
    const Json json = report(test::handmadeGarment());
    EXPECT_EQ(json["version"], 1);
    EXPECT_EQ(json["toile"], std::string(version()));
    ASSERT_EQ(json["files"].size(), 1u);
    const Json& file = json["files"][0];
    EXPECT_EQ(file["path"], "made/by hand.obj");
    EXPECT_EQ(file["unit"], "cm");
    EXPECT_EQ(file["unit_reason"], "largest extent 10: read as centimetres");
    EXPECT_EQ(file["vertices"], 11);
    EXPECT_EQ(file["faces"], 5);
    EXPECT_EQ(file["seconds_read"], 0.5);
    ASSERT_EQ(json["pieces"].size(), 3u);
    EXPECT_EQ(json["pieces"][0]["name"], "front 1");
    EXPECT_EQ(json["pieces"][0]["file"], "made/by hand.obj");
}

TEST(WriteReport, SaysWhatPiecesAreOfAndWhatIsOnTheirLabels) {
    const test::GarmentAndResults all = test::handmadeGarment();
    Pattern pattern;
    pattern.pieces.resize(3);
    const Json bare = Json::parse(writeReport(all.garment, all.results, pattern));
    for (const char* key : {"materials", "size", "date"}) {
        EXPECT_FALSE(bare.contains(key)) << key;
    }
    EXPECT_FALSE(bare["pieces"][1].contains("material"));
    pattern.pieces[1].material = "Lining";
    pattern.materials = {{"Lining", *fabricPreset("jersey")}, {"Shell", *fabricPreset("denim")}};
    pattern.label = {"M", "2026-01-31"};
    const Json json = Json::parse(writeReport(all.garment, all.results, pattern));
    EXPECT_EQ(json["size"], "M");
    EXPECT_EQ(json["date"], "2026-01-31");
    EXPECT_EQ(json["pieces"][1]["material"], "Lining");
    EXPECT_EQ(json["materials"], (Json::array({{{"name", "Lining"},
                                                {"fabric", "jersey"},
                                                {"warp", {-0.05, 0.15}},
                                                {"weft", {-0.08, 0.35}},
                                                {"bias", {-0.06, 0.25}},
                                                {"width_mm", 1600.0}}})));
}

TEST(WriteReport, GivesTheFiguresOfAFlatPiece) {
    const Json piece = report(test::handmadeGarment())["pieces"][0];
    EXPECT_EQ(piece["status"], "flat");
    EXPECT_TRUE(piece["error"].is_null());
    EXPECT_EQ(piece["method"], "wang2005");
    EXPECT_EQ(piece["boundary_solver"], "newton");
    EXPECT_EQ(piece["vertices"], 5);
    EXPECT_EQ(piece["triangles"], 3);
    EXPECT_EQ(piece["boundary_edges"], 5);
    EXPECT_EQ(piece["area_3d"], 187.5);
    EXPECT_EQ(piece["pi_theta"], 0.125);
    EXPECT_EQ(piece["symmetric_dirichlet"], 1.0625);
    EXPECT_EQ(piece["flipped_triangles"], 0);
    EXPECT_EQ(piece["boundary_iterations"], 4);
    EXPECT_EQ(piece["closure_gap"], 1.5e-14);
    EXPECT_EQ(piece["angle_energy"], 0.25);
    EXPECT_EQ(piece["interior_iterations"], 0);
    EXPECT_EQ(piece["delaunay_flips"], 0);
    EXPECT_EQ(piece["notes"], Json::array());
    EXPECT_EQ(piece["seconds"],
              (Json{{"read", 0.5}, {"boundary", 0.001}, {"interior", 0.002}, {"total", 0.004}}));
    for (const char* key : {"area_2d", "perimeter_3d", "perimeter_2d", "pi_l", "pi_e", "pi_a",
                            "max_boundary_length_error", "outline_crossings"}) {
        EXPECT_TRUE(piece[key].is_number()) << key;
    }
    for (const char* key : {"quasi_conformal_mean", "quasi_conformal_max", "strain_min",
                            "strain_max", "strain_mean_abs"}) {
        EXPECT_TRUE(piece.contains(key)) << key;
    }
}

TEST(WriteReport, WritesNullForWhatIsNotThereOrNotFinite) {
    const Json natural = report(test::handmadeGarment())["pieces"][2];
    for (const char* key : {"boundary_solver", "boundary_iterations", "closure_gap", "angle_energy",
                            "symmetric_dirichlet", "pi_e", "strain_max"}) {
        EXPECT_TRUE(natural.at(key).is_null()) << key;
    }
    EXPECT_EQ(natural["method"], "natural");
}

TEST(WriteReport, SaysHowOftenAPieceIsCut) {
    const auto all = test::handmadeGarment();
    Pattern pattern = makePattern(all.garment, all.results);
    pattern.pieces[1].quantity = 4;
    pattern.pieces[1].mirroredPair = true;
    const Json pieces = Json::parse(writeReport(all.garment, all.results, pattern))["pieces"];
    EXPECT_EQ(pieces[0]["quantity"], 1);
    EXPECT_EQ(pieces[0]["mirrored_pair"], false);
    EXPECT_EQ(pieces[1]["quantity"], 4);
    EXPECT_EQ(pieces[1]["mirrored_pair"], true);
    EXPECT_EQ(writeReport(all.garment, all.results),
              writeReport(all.garment, all.results, makePattern(all.garment, all.results)));
}

TEST(WriteReport, SaysWhatTheInteriorTookAndWhatIsNoted) {
    test::GarmentAndResults all = test::handmadeGarment();
    auto result = std::make_shared<PieceResult>(*all.results[0]);
    result->flat->interiorIterations = 7;
    result->flat->delaunayFlips = 12;
    result->flat->notes = {{ErrorCode::HolesKept, Subject::piece("front 1", {1}), "1 hole"}};
    all.results[0] = result;
    const Json piece = report(all)["pieces"][0];
    EXPECT_EQ(piece["interior_iterations"], 7);
    EXPECT_EQ(piece["delaunay_flips"], 12);
    ASSERT_EQ(piece["notes"].size(), 1u);
    EXPECT_EQ(piece["notes"][0]["code"], "holes-kept");
    EXPECT_EQ(piece["notes"][0]["message"], sentence(result->flat->notes[0]));
}

TEST(WriteReport, SaysWhyAPieceFailedAndKeepsItsCounts) {
    const Json json = report(test::handmadeGarment());
    const Json& ring = json["pieces"][1];
    EXPECT_EQ(ring["status"], "failed");
    EXPECT_EQ(ring["error"]["code"], "several-loops");
    EXPECT_NE(ring["error"]["message"].get<std::string>().find("2 loops"), std::string::npos);
    EXPECT_EQ(ring["vertices"], 3);
    EXPECT_EQ(ring["triangles"], 1);
    for (const auto& [key, value] : json["pieces"][0].items()) {
        ASSERT_TRUE(ring.contains(key)) << "every piece has every field: " << key;
    }
    for (const char* key :
         {"boundary_edges", "area_3d", "pi_a", "flipped_triangles", "outline_crossings",
          "boundary_iterations", "angle_energy", "interior_iterations", "delaunay_flips"}) {
        EXPECT_TRUE(ring[key].is_null()) << key;
    }
    EXPECT_TRUE(ring["seconds"]["boundary"].is_null());
}

TEST(WriteReport, ListsEachProblemOnceWithItsPiece) {
    const Json problems = report(test::handmadeGarment())["files"][0]["problems"];
    std::vector<std::string> codes;
    for (const Json& problem : problems) {
        codes.push_back(problem["code"]);
        EXPECT_TRUE(problem["message"].is_string());
    }
    EXPECT_EQ(codes, (std::vector<std::string>{"output-differs", "unit-guessed",
                                               "degenerate-face-record", "several-loops"}));
    EXPECT_TRUE(problems[0]["piece"].is_null());
    EXPECT_EQ(problems[3]["piece"], "ring");
}

TEST(WriteReport, TakesNamesThatAreNoText) {
    test::GarmentAndResults all = test::handmadeGarment();
    auto piece = std::make_shared<Piece>(*all.garment.pieces[0]);
    piece->name = "\xC4rmel \"1\"\n";
    all.garment.pieces[0] = piece;
    EXPECT_EQ(report(all)["pieces"][0]["name"], "\xEF\xBF\xBDrmel \"1\"\n");
}

void expectDocumented(const Json& json, const std::string& page) {
    for (const auto& [key, value] : json.items()) {
        if (json.is_object()) {
            EXPECT_NE(page.find("`" + key + "`"), std::string::npos) << key;
        }
        if (value.is_structured()) {
            expectDocumented(value, page);
        }
    }
}

TEST(WriteReport, HasNoFieldThatIsNotInItsDocumentation) {
    const auto page = readFile(test::sourceFile("docs/report.md"));
    ASSERT_TRUE(page);
    test::GarmentAndResults all = test::handmadeGarment();
    all.garment.cuts = {{"inseam", CutAuthor::User, UserCut::Kind::Path, "front 1", 12}};
    all.garment.problems = {{ErrorCode::HolesKept, Subject::piece("front 1", {1}), "1 hole"}};
    Seam edge;
    edge.kind = SeamKind::Free;
    edge.left.piece = 1;
    all.garment.seams.seams = {edge};
    expectDocumented(report(all), *page);
    expectDocumented(Json::parse(writeInfo(all.garment)), *page);
}

TEST(WriteReport, GivesTheSameBytesTwiceAndInAnyLocale) {
    const test::GarmentAndResults all = test::handmadeGarment();
    const std::string bytes = writeReport(all.garment, all.results);
    EXPECT_TRUE(bytes.ends_with("}\n"));
    EXPECT_EQ(bytes, writeReport(all.garment, all.results));
    const test::CommaLocale comma;
    EXPECT_EQ(bytes, writeReport(all.garment, all.results));
}

TEST(WriteReport, TakesAGarmentWithoutPieces) {
    const Json json = Json::parse(writeReport({}, {}));
    EXPECT_TRUE(json["files"].is_array() && json["files"].empty());
    EXPECT_TRUE(json["pieces"].is_array() && json["pieces"].empty());
}

}  // namespace
}  // namespace toile
