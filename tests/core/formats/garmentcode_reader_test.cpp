// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/garmentcode/garmentcode_reader.h"

#include <random>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/formats/read_pattern.h"
#include "core/geometry/polygon.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

/// A square of 10 cm; its first edge is curved as said.
std::string squareWith(const std::string& curvature, const std::string& more = "") {
    return R"({"pattern":{"panels":{"a":{"translation":[1,2,3],"rotation":[0,90,0],)"
           R"("vertices":[[0,0],[10,0],[10,10],[0,10]],"edges":[{"endpoints":[0,1])" +
           (curvature.empty() ? "" : ",\"curvature\":" + curvature) +
           R"(},{"endpoints":[1,2]},{"endpoints":[2,3]},{"endpoints":[3,0]}]}},)"
           R"("stitches":[[{"panel":"a","edge":1},{"panel":"a","edge":3}]]},)"
           R"("properties":{"curvature_coords":"relative","units_in_meter":100})" +
           more + "}";
}

GarmentCode readCode(const std::string& bytes) {
    auto code = readGarmentCode(bytes);
    EXPECT_TRUE(code) << (code ? "" : sentence(code.error()));
    return code ? std::move(*code) : GarmentCode{};
}

double firstLength(const std::string& curvature) {
    const GarmentCode code = readCode(squareWith(curvature));
    return code.panels.empty() ? 0 : code.panels.front().edges.front().length;
}

TEST(GarmentCodeReader, ReadsPanelsStitchesAndPlacesInMillimetres) {
    const GarmentCode code = readCode(squareWith(""));
    ASSERT_EQ(code.panels.size(), 1U);
    const GarmentCodePanel& panel = code.panels.front();
    EXPECT_EQ(panel.translation, Eigen::Vector3d(10, 20, 30));
    EXPECT_EQ(panel.rotation, Eigen::Vector3d(0, 90, 0));
    ASSERT_EQ(panel.edges.size(), 4U);
    EXPECT_DOUBLE_EQ(panel.edges.front().length, 100);
    ASSERT_EQ(code.stitches.size(), 1U);
    EXPECT_EQ(code.stitches.front().sides[1].edge, 3);
    const PatternFile file = patternOf(code);
    EXPECT_EQ(file.unit, LengthUnit::Centimetre);
    ASSERT_EQ(file.pieces.size(), 1U);
    EXPECT_DOUBLE_EQ(geometry::signedAreaOf(file.pieces.front().sew), 1e4);
    EXPECT_EQ(file.pieces.front().cut.rows(), 0);
}

TEST(GarmentCodeReader, RecognisesFilesByTheirContent) {
    const test::TemporaryFolder folder;
    const auto named = folder.write("default_pattern.json", squareWith(""));
    const auto file = readPatternFile(named);
    ASSERT_TRUE(file) << sentence(file.error());
    EXPECT_EQ(file->pieces.size(), 1U);
    EXPECT_FALSE(patternFileKind(folder.write("report.json", "{\"pieces\":[]}")));
    EXPECT_FALSE(patternFileKind(folder / "none.json"));
}

TEST(GarmentCodeReader, ReadsBothFormsOfAQuadraticCurveAlike) {
    const double old = firstLength("[0.3,0.4]");
    EXPECT_DOUBLE_EQ(old, firstLength(R"({"type":"quadratic","params":[[0.3,0.4]]})"));
    EXPECT_GT(old, 100);
    // The same curve as a cubic one.
    EXPECT_NEAR(old,
                firstLength(R"({"type":"cubic","params":[[0.2,0.26666666666666666],)"
                            "[0.5333333333333333,0.26666666666666666]]}"),
                1e-9);
    EXPECT_DOUBLE_EQ(firstLength(R"({"type":"cubic","params":[[0.3,0],[0.6,0]]})"), 100);
}

TEST(GarmentCodeReader, ReadsPartsOfCircles) {
    const double radius = 100 / std::sqrt(2), chord = 7.0710678118654755;
    const std::string r = std::to_string(chord);
    EXPECT_NEAR(firstLength(R"({"type":"circle","params":[)" + r + ",0,1]}"), radius * kPi / 2,
                1e-3);
    EXPECT_NEAR(firstLength(R"({"type":"circle","params":[)" + r + ",1,0]}"), radius * 3 * kPi / 2,
                1e-3);
    const double segment = radius * radius * (kPi / 4 - 0.5);
    // On the right of an edge that runs anti-clockwise is outside.
    for (const bool isRight : {true, false}) {
        const GarmentCode code = readCode(
            squareWith(R"({"type":"circle","params":[)" + r + ",0," + (isRight ? "1]}" : "0]}")));
        EXPECT_NEAR(geometry::signedAreaOf(outlineOf(code.panels.front())),
                    1e4 + (isRight ? segment : -segment), 1);
    }
}

TEST(GarmentCodeReader, SaysWhatIsWrongAndWhere) {
    const struct {
        std::string from, to, place;
    } cases[] = {{R"("endpoints":[1,2])", R"("endpoints":[1,7])", "pattern.panels.a.edges[1]"},
                 {R"("endpoints":[1,2])", R"("endpoints":[2,1])", "pattern.panels.a.edges"},
                 {R"("edge":3)", R"("edge":4)", "stitches[0]"},
                 {R"("panel":"a","edge":3)", R"("panel":"b","edge":3)", "stitches[0]"},
                 {"[10,0]", R"([10,"x"])", "vertices[1]"},
                 {R"("pattern")", R"("patter")", "pattern"}};
    for (const auto& [from, to, place] : cases) {
        std::string bytes = squareWith("");
        bytes.replace(bytes.find(from), from.size(), to);
        const auto code = readGarmentCode(bytes);
        ASSERT_FALSE(code) << to;
        EXPECT_EQ(code.error().code, ErrorCode::MalformedFile);
        EXPECT_NE(code.error().detail.find(place), std::string::npos) << code.error().detail;
    }
    EXPECT_FALSE(readGarmentCode(squareWith(R"({"type":"spiral","params":[]})")));
    EXPECT_FALSE(readGarmentCode(""));
}

TEST(GarmentCodeReader, SurvivesWhateverIsChanged) {
    const std::string whole = squareWith(R"({"type":"circle","params":[7,0,1]})");
    std::mt19937 random(3);
    for (int trial = 0; trial < 3000; ++trial) {
        std::string bytes = whole;
        for (int change = 0; change < 2; ++change) {
            bytes[random() % bytes.size()] = "0123456789-.,[]{}\"e"[random() % 19];
        }
        const auto code = readGarmentCode(bytes);
        for (const GarmentCodePanel& panel :
             code ? code->panels : std::vector<GarmentCodePanel>{}) {
            EXPECT_TRUE(outlineOf(panel).allFinite()) << bytes;
        }
    }
}

TEST(GarmentCodeReader, ReadsItsOwnProgramsFiles) {
    const struct {
        const char* name;
        std::size_t panels, stitches;
    } files[] = {
        {"patterns/gc_shirt", 8, 18}, {"patterns/gc_hoody", 6, 12}, {"garments/tee_sim", 6, 12}};
    for (const auto& [name, panels, stitches] : files) {
        const auto path = test::dataFile(std::string(name) + ".specification.json");
        TOILE_NEEDS_SHARED(path);
        const GarmentCode code = readCode(*readFile(path));
        EXPECT_EQ(code.panels.size(), panels) << name;
        EXPECT_EQ(code.stitches.size(), stitches) << name;
        EXPECT_DOUBLE_EQ(code.unit, 10);
        for (const GarmentCodePanel& panel : code.panels) {
            EXPECT_NE(geometry::signedAreaOf(outlineOf(panel)), 0) << panel.name;
        }
    }
}

TEST(GarmentCodeReader, FindsTheAreasOfTheMeasuredPanels) {
    const auto path = test::dataFile("garments/tee_sim.specification.json"),
               truth = test::dataFile("garments/tee_sim.truth.json");
    TOILE_NEEDS_SHARED(path);
    TOILE_NEEDS_SHARED(truth);
    const auto json = nlohmann::json::parse(*readFile(truth));
    const PatternFile file = patternOf(readCode(*readFile(path)));
    int found = 0;
    for (const auto& panel : json["panels"]) {
        for (const FilePiece& piece : file.pieces) {
            if (piece.name == panel["name"]) {
                const double area = 100 * panel["area_2d"].get<double>();
                EXPECT_NEAR(geometry::signedAreaOf(piece.sew), area, 1e-3 * area) << piece.name;
                ++found;
            }
        }
    }
    EXPECT_EQ(found, 6);
}

TEST(GarmentCodeReader, DoubtsAUnitThatIsNone) {
    std::string bytes = squareWith("");
    bytes.replace(bytes.find("\"units_in_meter\":100"), 20, "\"units_in_meter\":1e-320");
    const GarmentCode code = readCode(bytes);
    EXPECT_TRUE(code.unitInDoubt);
    EXPECT_EQ(code.unit, 10);
}

TEST(GarmentCodeReader, RefusesAPanelWithNothingInIt) {
    const auto lens = [](const std::string& curvature) {
        return R"({"pattern":{"panels":{"a":{"vertices":[[0,0],[9,9]],"edges":[{"endpoints":[0,1])" +
               curvature + R"(},{"endpoints":[1,0]}]}}}})";
    };
    EXPECT_FALSE(readGarmentCode(lens("")));
    EXPECT_TRUE(readGarmentCode(lens(",\"curvature\":[0.5,0.5]")));
}

}  // namespace
}  // namespace toile
