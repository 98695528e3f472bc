// SPDX-License-Identifier: GPL-3.0-or-later
// `toile compare`: what other programs and people may rely on, and the tables of
// docs/comparison.md.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/flatten/base/flat_piece.h"
#include "tests/cli/docs_table.h"
#include "tests/cli/run_program.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

using Json = nlohmann::json;

const std::string kSamples = std::string(TOILE_SOURCE_DIR) + "/resources/samples/";

test::ProgramRun compare(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "compare");
    return test::run(TOILE_PROGRAM, arguments);
}

TEST(Compare, PrintsARowPerMethodInTheOrderTyped) {
    const auto run =
        compare({kSamples + "tshirt.obj", "--unit", "mm", "--methods", "natural,wang2005"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_TRUE(run.out.starts_with("tshirt.obj: 5 pieces, 5714 triangles, 14 seams\n")) << run.out;
    for (const char* head : {"time ms", "Pi_theta", "Pi_E", "Pi_A", "SD", "length error", "flips",
                             "crossings", "seam mm"}) {
        EXPECT_NE(run.out.find(head), std::string::npos) << head;
    }
    EXPECT_LT(run.out.find("\nnatural "), run.out.find("\nwang2005 ")) << run.out;
    EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 4) << run.out;
    const auto pieces =
        compare({kSamples + "tshirt.obj", "--unit", "mm", "--methods", "natural", "--per-piece"});
    EXPECT_NE(pieces.out.find("\nneckband: 170 triangles\n"), std::string::npos) << pieces.out;
}

TEST(Compare, TellsTheSameAsTheReport) {
    const test::TemporaryFolder folder;
    const auto run =
        compare({kSamples + "cap.obj", "--unit", "mm", "--methods", "wang2005,natural", "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    const Json comparison = Json::parse(run.out);
    ASSERT_EQ(comparison["methods"].size(), 2U);
    for (const Json& method : comparison["methods"]) {
        const std::string report = (folder / "a.json").string();
        test::run(TOILE_PROGRAM, {"flatten", kSamples + "cap.obj", "--unit", "mm", "--method",
                                  method["method"], "--report", report});
        const Json told = Json::parse(folder.read("a.json"));
        ASSERT_EQ(method["pieces"].size(), told["pieces"].size());
        double error = 0;
        for (std::size_t k = 0; k < told["pieces"].size(); ++k) {
            for (const char* key : {"name", "status", "error", "triangles", "pi_theta", "pi_e",
                                    "pi_a", "symmetric_dirichlet", "max_boundary_length_error",
                                    "flipped_triangles", "outline_crossings"}) {
                EXPECT_EQ(method["pieces"][k][key], told["pieces"][k][key]) << key;
            }
        }
        for (const Json& seam : told["seams"]) {
            if (seam["kind"] != "free") {
                error = std::max(error, std::abs(seam["error_mm"].get<double>()));
            }
        }
        EXPECT_NEAR(method["seam_mismatch_mm"].get<double>(), error, 1e-9);
        EXPECT_TRUE(method["reference_rms_mm"].is_null());
    }
}

TEST(Compare, FailedPiecesAreCountedAndNamedOnce) {
    const test::TemporaryFolder folder;
    const auto input = folder.write("mixed.obj", std::string(test::kTriangle) + test::kBall);
    const auto run = compare({input.string(), "--unit", "mm", "--methods", "wang2005,natural"});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.out.find("failed"), std::string::npos) << run.out;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_TRUE(run.err.starts_with("toile: ball: ")) << run.err;
}

TEST(Compare, UnknownMethodsAndFilesAreRefused) {
    const auto method = compare({kSamples + "cap.obj", "--methods", "natural,magic"});
    EXPECT_EQ(method.status, 2);
    EXPECT_EQ(std::count(method.err.begin(), method.err.end(), '\n'), 1) << method.err;
    EXPECT_EQ(compare({"missing.obj"}).status, 3);
}

TEST(Compare, TakesEveryMethodAndHoldsItToItsPromise) {
    const auto run = compare({kSamples + "shapes/cube-h.obj", "--unit", "mm", "--json"});
    EXPECT_TRUE(run.status == 0 || run.status == 1) << run.err;
    const Json methods = Json::parse(run.out)["methods"];
    EXPECT_EQ(methods.size(), allMethods().size());
    for (const Json& method : methods) {
        const bool keeps = method["keeps_lengths"];
        if (keeps && method["failed"] == 0) {
            EXPECT_LE(method["max_boundary_length_error"].get<double>(), 1e-9) << method["method"];
        }
    }
}

struct ShownCase {
    const char* name;
    const char* file;                  ///< of the samples, or of the shared data
    std::vector<std::string> options;  ///< as the page says
    bool isSample = false;
};

class ComparisonPage : public testing::TestWithParam<ShownCase> {};

TEST_P(ComparisonPage, IsWhatTheProgramPrints) {
    const ShownCase& shown = GetParam();
    const auto file = shown.isSample ? std::filesystem::path(kSamples + shown.file)
                                     : test::sharedFile(shown.file);
    TOILE_NEEDS_SHARED(file);
    std::vector<std::string> arguments{file.string(), "--markdown"};
    arguments.insert(arguments.end(), shown.options.begin(), shown.options.end());
    const auto run = compare(arguments);
    ASSERT_TRUE(run.status == 0 || run.status == 1) << run.err;
    if (shown.isSample) {
        test::expectFiguresInDocs("comparison.md", shown.name, run.out);
    } else {
        test::updateTableInDocs("comparison.md", shown.name, run.out);
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, ComparisonPage,
                         testing::Values(ShownCase{
                             "cube", "shapes/cube-h.obj", {"--unit", "mm"}, true}),
                         [](const auto& shown) { return std::string(shown.param.name); });
INSTANTIATE_TEST_SUITE_P(SharedSlow, ComparisonPage,
                         testing::Values(ShownCase{"mannequin", "disks/mannequin-devil.off", {}},
                                         ShownCase{
                                             "dress", "garments/dress.obj", {"--split", "uv"}},
                                         ShownCase{"polo", "garments/polo.obj", {"--split", "uv"}}),
                         [](const auto& shown) { return std::string(shown.param.name); });

TEST(ComparisonPage, IsComparedToRoundingAndWithoutTimes) {
    const std::string table =
        "tee.obj: 6 pieces\n\n| method | time ms | Pi_E | length error | flips "
        "|\n|---|--:|--:|--:|\n"
        "| `lscm` | 3.1 | 0.0125 | 2.1e-14 | 58 |\n\nNearer: lscm (2.10 mm against 2.41).\n";
    const auto with = [&table](const std::string& old, const std::string& now) {
        std::string changed = table;
        changed.replace(changed.find(old), old.size(), now);
        return test::differingFigures(table, changed);
    };
    EXPECT_EQ(with("3.1", "99"), "");
    EXPECT_EQ(with("0.0125", "0.0126"), "");
    EXPECT_EQ(with("2.1e-14", "9.9e-12"), "");
    EXPECT_EQ(with("58", "57"), "");
    EXPECT_EQ(with("2.41", "2.42"), "");
    EXPECT_NE(with("0.0125", "0.0128"), "");
    EXPECT_NE(with("0.0125", "-"), "");
    EXPECT_NE(with("2.1e-14", "2.1e-03"), "");
    EXPECT_NE(with("58", "0"), "");
    EXPECT_NE(with("6 pieces", "7 pieces"), "");
    EXPECT_NE(with("`lscm`", "`abf`"), "");
    EXPECT_NE(with("time ms", "flips"), "");
    EXPECT_NE(with("Nearer: lscm", "Nearer: abf"), "");

    const std::string head = "| method | SD | flips |\n|---|--:|--:|\n";
    const auto differ = [&head](const std::string& ours, const std::string& theirs) {
        return test::differingFigures(head + ours, head + theirs);
    };
    EXPECT_EQ(differ("| `lscm` | - | 1 |\n", "| `lscm` | 1.4e+23 | 0 |\n"), "");
    EXPECT_NE(differ("| `lscm` | - | 1 |\n", "| `lscm` | 8.0864 | 0 |\n"), "");
    EXPECT_NE(differ("| `lscm` | - | 3 |\n", "| `lscm` | 1.4e+23 | 0 |\n"), "");
    EXPECT_NE(differ("| `lscm` | 8.0864 | 1 |\n", "| `lscm` | 8.0864 | 0 |\n"), "");
}

}  // namespace
}  // namespace toile
