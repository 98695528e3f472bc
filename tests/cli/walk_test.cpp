// SPDX-License-Identifier: GPL-3.0-or-later
// `toile walk`, with the built program.
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"

namespace toile {
namespace {

const std::string kWalked = std::string(TOILE_SOURCE_DIR) + "/resources/samples/tshirt.obj";

TEST(WalkCommand, ListsEveryStationOfASeam) {
    const auto run = test::toileRun({"walk", kWalked, "--unit", "mm", "--method", "curvature"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    for (const char* said :
         {"front / sleeve_left", "sleeve head", "balance, double", "largest error 0.000000 mm"}) {
        EXPECT_NE(run.out.find(said), std::string::npos) << said << '\n' << run.out;
    }
}

TEST(WalkCommand, JsonHasTheLengthsFromStationToStation) {
    const auto run = test::toileRun(
        {"walk", kWalked, "--unit", "mm", "--method", "curvature", "--true", "--json"});
    EXPECT_EQ(run.status, 0) << run.err;
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_LE(json["largest_error_mm"].get<double>(), 1e-6);
    ASSERT_FALSE(json["seams"].empty());
    for (const auto& seam : json["seams"]) {
        const auto& stations = seam["stations"];
        ASSERT_GE(stations.size(), 2U);
        EXPECT_EQ(stations.front()["station"], "start");
        EXPECT_EQ(stations.back()["station"], "end");
        for (const auto& station : stations) {
            EXPECT_NEAR(station["length_2d_left"].get<double>(),
                        station["length_2d_right"].get<double>() +
                            station["ease_mm"].get<double>() + station["error_mm"].get<double>(),
                        1e-9);
        }
    }
}

TEST(WalkCommand, UnequalLengthsAreStatusOneAndNoSeamIsNone) {
    const auto natural = test::toileRun({"walk", kWalked, "--unit", "mm", "--method", "natural"});
    EXPECT_EQ(natural.status, 1);
    EXPECT_EQ(natural.out.find("largest error 0.000000"), std::string::npos);
    const test::TemporaryFolder folder;
    const auto alone =
        test::toileRun({"walk", folder.write("a.obj", test::kPanel).string(), "--unit", "mm"});
    EXPECT_EQ(alone.status, 0) << alone.err;
    EXPECT_NE(alone.out.find("no seam to walk"), std::string::npos);
    EXPECT_EQ(test::toileRun({"walk", "nowhere.obj"}).status, 3);
    EXPECT_EQ(test::toileRun({"walk"}).status, 2);
}

}  // namespace
}  // namespace toile
