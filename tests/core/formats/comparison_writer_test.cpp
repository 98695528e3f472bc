// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/tables/comparison_writer.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/version.h"
#include "tests/core/formats/export_fixtures.h"

namespace toile {
namespace {

using Json = nlohmann::json;

/// The handmade garment, whose piece "ring" has failed and whose "back" has figures that are no
/// numbers, once as it is and once without any flat piece.
struct Compared {
    test::GarmentAndResults all = test::handmadeGarment();
    Comparison comparison;

    Compared() {
        PieceResults none;
        for (const auto& result : all.results) {
            auto failed = std::make_shared<PieceResult>();
            failed->piece = result->piece;
            failed->error = Error{ErrorCode::BoundaryNotConverged, subjectOf(*result->piece)};
            none.push_back(failed);
        }
        comparison.methods.push_back(compared(Method::Natural, all.garment, all.results));
        comparison.methods.push_back(compared(Method::Wang2005, all.garment, none));
    }
};

TEST(WriteComparison, GivesFullDigitsPerMethodAndPieceAndNeverNaN) {
    const Compared made;
    const std::string text = writeComparison(made.all.garment, made.comparison);
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf"), std::string::npos);
    const Json json = Json::parse(text);
    EXPECT_EQ(json["version"], 1);
    EXPECT_EQ(json["toile"], std::string(version()));
    EXPECT_EQ(json["files"].size(), 1U);
    EXPECT_TRUE(json["nearer_than_length_keeping"].empty());
    ASSERT_EQ(json["methods"].size(), 2U);
    const Json& natural = json["methods"][0];
    EXPECT_EQ(natural["method"], "natural");
    EXPECT_EQ(natural["keeps_lengths"], false);
    EXPECT_EQ(natural["pieces_flat"], 2);
    EXPECT_EQ(natural["failed"], 1);
    EXPECT_TRUE(natural["pi_e"].is_null());  // one piece's is no number
    EXPECT_TRUE(natural["symmetric_dirichlet"].is_null());
    EXPECT_EQ(natural["flipped_triangles"], 0);
    ASSERT_EQ(natural["pieces"].size(), 3U);
    EXPECT_EQ(natural["pieces"][0]["name"], "front 1");
    EXPECT_EQ(natural["pieces"][0]["pi_theta"], 0.125);
    EXPECT_EQ(natural["pieces"][0]["seconds"], 0.003);
    EXPECT_EQ(natural["pieces"][1]["status"], "failed");
    EXPECT_EQ(natural["pieces"][1]["error"]["code"], "several-loops");
    const Json& none = json["methods"][1];
    EXPECT_EQ(none["failed"], 3);
    for (const char* key : {"seconds", "pi_theta", "pi_e", "pi_a", "symmetric_dirichlet",
                            "max_boundary_length_error", "flipped_triangles", "outline_crossings",
                            "seam_mismatch_mm", "reference_rms_mm", "sewn_gap_mm"}) {
        EXPECT_TRUE(none.contains(key) && none[key].is_null()) << key;
    }
}

TEST(ComparisonTable, LeavesOutColumnsWithoutAFigure) {
    const Compared made;
    const auto tables = comparisonTables(made.all.garment, made.comparison, true);
    ASSERT_EQ(tables.size(), 4U);
    const ComparisonTable& whole = tables.front();
    const auto has = [](const ComparisonTable& table, const char* head) {
        return std::ranges::find(table.head, head) != table.head.end();
    };
    EXPECT_TRUE(has(whole, "failed"));
    EXPECT_FALSE(has(whole, "rms mm"));
    EXPECT_TRUE(whole.title.starts_with("by hand.obj: 3 pieces, 6 triangles")) << whole.title;
    ASSERT_EQ(whole.rows.size(), 2U);
    for (const auto& row : whole.rows) {
        EXPECT_EQ(row.size(), whole.head.size());
    }
    EXPECT_EQ(whole.rows[1][1], "-");
    EXPECT_EQ(tables[1].title, "front 1: 3 triangles");
    EXPECT_EQ(comparisonTables(made.all.garment, made.comparison, false).size(), 1U);
}

TEST(ComparisonTable, KnowsNoLocale) {
    const Compared made;
    const std::string before = writeComparisonMarkdown(made.all.garment, made.comparison, true);
    const test::CommaLocale comma;
    EXPECT_EQ(writeComparisonMarkdown(made.all.garment, made.comparison, true), before);
}

TEST(ComparisonMarkdown, IsATablePerPieceAndASentence) {
    Compared made;
    auto& methods = made.comparison.methods;
    methods[0].figures.referencedPieces = methods[1].figures.referencedPieces = 2;
    methods[0].figures[Criterion::ReferenceRms] = 2.1;
    methods[1].figures[Criterion::ReferenceRms] = 2.4;
    const std::string text = writeComparisonMarkdown(made.all.garment, made.comparison, false);
    EXPECT_NE(text.find("| method | time ms | Pi_theta |"), std::string::npos) << text;
    EXPECT_NE(text.find("\n|---|--:|--:|"), std::string::npos);
    EXPECT_NE(text.find("\n| `natural` | "), std::string::npos);
    EXPECT_NE(text.find("\nCloser to the given panels than any method that keeps seam lengths: "
                        "natural (2.10 mm against 2.40 of wang2005).\n"),
              std::string::npos)
        << text;
    const std::string all = writeComparisonMarkdown(made.all.garment, made.comparison, true);
    EXPECT_TRUE(all.starts_with(text));
    EXPECT_NE(all.find("\nring: 1 triangle\n"), std::string::npos) << all;
}

}  // namespace
}  // namespace toile
