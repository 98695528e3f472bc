// SPDX-License-Identifier: GPL-3.0-or-later
// Fair and trued lines by the command line: the tables of docs/patterns.md.
#include <cmath>
#include <cstdio>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/docs_table.h"
#include "tests/cli/run_program.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

using Json = nlohmann::json;

Json reportOf(const std::filesystem::path& garment, const std::vector<std::string>& options) {
    const test::TemporaryFolder folder;
    std::vector<std::string> arguments{"flatten", garment.string(), "--report",
                                       (folder / "a.json").string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto run = test::run(TOILE_PROGRAM, arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return Json::parse(folder.read("a.json"));
}

std::string degrees(double radians) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", radians * 180 / std::numbers::pi);
    return std::string(text) == "-0.0" ? "0.0" : text;
}

TEST(PatternsPage, TheKinksOfTheBodiceAreThoseOfTheProgram) {
    const Json report = reportOf(test::dataFile("samples/bodice.obj"), {"--true"});
    std::string table = "| Seam | Its | Kink ° | Trued ° |\n|---|---|--:|--:|\n";
    for (const Json& end : report["seam_ends"]) {
        table += "| " + end["seam"].get<std::string>() + " | " + end["end"].get<std::string>() +
                 " | " + degrees(end["kink_exact"]) + " | " + degrees(end["kink"]) + " |\n";
    }
    test::expectFiguresInDocs("patterns.md", "kinks", table);
}

TEST(FairOption, StandsAloneOrWithItsNumbers) {
    const std::string bodice = test::dataFile("samples/bodice.obj").string();
    const auto farthest = [&](const std::vector<std::string>& options) -> double {
        double most = 0;
        const Json report = reportOf(bodice, options);
        for (const Json& piece : report["pieces"]) {
            most = std::max(most, piece["line"]["farthest"].get<double>());
        }
        return most;
    };
    const double usual = farthest({"--fair"});
    EXPECT_LE(usual, 1);
    EXPECT_EQ(usual, farthest({"--fair=1,40"}));
    EXPECT_EQ(usual, farthest({"--fair", "1,40"}));
    EXPECT_LE(farthest({"--fair=0.2"}), 0.2);
    // What follows is a file unless it is a number.
    const auto run = test::run(TOILE_PROGRAM, {"flatten", "--fair", bodice});
    EXPECT_EQ(run.status, 0) << run.err;
    for (const char* wrong : {"--fair=0", "--fair=1,2000", "--fair=x", "--fair=1,2,3"}) {
        EXPECT_EQ(test::run(TOILE_PROGRAM, {"flatten", bodice, wrong}).status, 2) << wrong;
    }
}

TEST(FairOption, LeavesReportsAsTheyAreWhereItIsNotGiven) {
    const Json report = reportOf(test::dataFile("samples/bodice.obj"), {});
    EXPECT_FALSE(report.contains("seam_ends"));
    EXPECT_FALSE(report["pieces"][0].contains("line"));
}

}  // namespace
}  // namespace toile
