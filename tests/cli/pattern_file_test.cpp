// SPDX-License-Identifier: GPL-3.0-or-later
// `toile info` of patterns and `toile compare --pattern`.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

using Json = nlohmann::json;

/// Flattens one of our samples into a file of this ending.
std::string exported(const test::TemporaryFolder& folder, const std::string& sample,
                     const std::string& ending, std::vector<std::string> options = {}) {
    const std::string file = (folder / ("a" + ending)).string();
    std::vector<std::string> arguments{
        "flatten", test::dataFile("samples/" + sample).string(), "--unit", "mm", "-o", file};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto run = test::run(TOILE_PROGRAM, arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return file;
}

TEST(PatternInfo, TellsWhatAPatternHolds) {
    const test::TemporaryFolder folder;
    for (const char* ending : {".dxf", ".specification.json"}) {
        const std::string file = exported(folder, "tshirt.obj", ending);
        const auto run = test::run(TOILE_PROGRAM, {"info", file});
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_NE(run.out.find("5 pieces"), std::string::npos) << run.out;
        const char* name = ending == std::string(".dxf") ? "NECKBAND" : "neckband";
        EXPECT_NE(run.out.find(name), std::string::npos) << run.out;
        const auto json = test::run(TOILE_PROGRAM, {"info", file, "--json"});
        EXPECT_EQ(Json::parse(json.out)["pieces"].size(), 5U);
    }
}

TEST(PatternInfo, RefusesWhatIsNoPattern) {
    const test::TemporaryFolder folder;
    const auto run = test::run(TOILE_PROGRAM, {"info", folder.write("a.dxf", "hello").string()});
    EXPECT_EQ(run.status, 3);
    EXPECT_NE(run.err.find("a.dxf"), std::string::npos);
    EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
}

TEST(ComparePattern, FindsEveryPieceOfOurOwnExportsWhereItIs) {
    const test::TemporaryFolder folder;
    for (const char* sample : {"tshirt.obj", "cap.obj", "bodice.obj"}) {
        for (const char* ending : {".dxf", ".specification.json"}) {
            const std::string file = exported(folder, sample, ending);
            const std::string picture = (folder / "a.svg").string();
            const auto run =
                test::run(TOILE_PROGRAM,
                          {"compare", test::dataFile(std::string("samples/") + sample).string(),
                           "--unit", "mm", "--pattern", file, "--json", "-o", picture});
            ASSERT_EQ(run.status, 0) << sample << ending << run.err;
            const Json json = Json::parse(run.out);
            EXPECT_TRUE(json["without_partner"].empty());
            EXPECT_TRUE(json["without_partner_in_file"].empty());
            ASSERT_FALSE(json["pairs"].empty());
            for (const Json& pair : json["pairs"]) {
                const Json& line = pair["lines"][0];
                EXPECT_LT(line["max_distance"], 0.02) << pair;
                EXPECT_NEAR(line["length"], line["file_length"], 0.05) << pair;
            }
            EXPECT_NE(folder.read("a.svg").find("-theirs"), std::string::npos);
        }
    }
}

TEST(ComparePattern, NamesWhatHasNoPartner) {
    const test::TemporaryFolder folder;
    const std::string file = exported(folder, "cap.obj", ".dxf");
    const auto run =
        test::run(TOILE_PROGRAM, {"compare", test::dataFile("samples/tshirt.obj").string(),
                                  "--unit", "mm", "--pattern", file});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.out.find("pieces without a match: "), std::string::npos) << run.out;
}

TEST(ComparePattern, WantsAPatternForAPicture) {
    const auto run = test::run(TOILE_PROGRAM, {"compare", "a.obj", "-o", "a.svg"});
    EXPECT_EQ(run.status, 2);
}

TEST(ComparePattern, LaysTheSkirtOfAnotherProgramOverItsOwnPattern) {
    const auto garment = test::dataFile("garments/skirt_clo.obj"),
               pattern = test::dataFile("patterns/skirt_clo.dxf");
    TOILE_NEEDS_SHARED(garment);
    TOILE_NEEDS_SHARED(pattern);
    const auto run = test::run(
        TOILE_PROGRAM, {"compare", garment.string(), "--pattern", pattern.string(), "--json"});
    EXPECT_EQ(run.status, 0) << run.err;
    const Json json = Json::parse(run.out);
    ASSERT_EQ(json["pairs"].size(), 4U);
    for (const Json& pair : json["pairs"]) {
        EXPECT_LT(pair["lines"][0]["mean_distance"], 20);  // the cloth is strained by 22 %
        EXPECT_TRUE(pair["also_fits"].empty()) << pair;
    }
}

TEST(ComparePattern, SaysWhichHalfSleevesAreAlike) {
    const auto garment = test::dataFile("garments/tee_sim.obj"),
               pattern = test::dataFile("garments/tee_sim.specification.json");
    TOILE_NEEDS_SHARED(garment);
    TOILE_NEEDS_SHARED(pattern);
    const auto run = test::run(
        TOILE_PROGRAM, {"compare", garment.string(), "--pattern", pattern.string(), "--json"});
    EXPECT_EQ(run.status, 0) << run.err;
    const Json json = Json::parse(run.out);
    ASSERT_EQ(json["pairs"].size(), 6U);
    int doubtful = 0;
    for (const Json& pair : json["pairs"]) {
        EXPECT_LT(pair["lines"][0]["mean_distance"], 2) << pair;
        doubtful += pair["also_fits"].empty() ? 0 : 1;
    }
    EXPECT_EQ(doubtful, 4);
}

}  // namespace
}  // namespace toile
