// SPDX-License-Identifier: GPL-3.0-or-later
// `toile marker`, with the built program.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "tests/cli/run_program.h"

namespace toile {
namespace {

const char* const kNested = R"({"name": "halves", "strip_height": 30, "items": [
    {"id": 0, "demand": 4, "allowed_orientations": [0, 180],
     "shape": {"type": "simple_polygon", "data": [[0, 0], [40, 0], [0, 30]]}}]})";

TEST(MarkerCommand, NestsAnInstanceAndReportsIt) {
    const test::TemporaryFolder folder;
    const auto file = folder.write("halves.json", kNested);
    const auto nest = [&](const std::string& threads) {
        const auto report = folder / ("report" + threads + ".json");
        const auto picture = folder / ("nest" + threads + ".svg");
        const auto run =
            test::toileRun({"marker", file.string(), "--rounds", "3", "--threads", threads,
                            "--report", report.string(), "-o", picture.string()});
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_NE(run.out.find("3 rounds"), std::string::npos) << run.out;
        return *readFile(report) + *readFile(picture);
    };
    const std::string written = nest("1");
    EXPECT_EQ(nest("2"), written);
    const auto json = nlohmann::json::parse(*readFile(folder / "report1.json"));
    EXPECT_GT(json["use"].get<double>(), 0.9);
    EXPECT_EQ(json["rounds"], 3);
    EXPECT_EQ(json["placements"].size(), 4U);
    EXPECT_NE(written.find("<svg"), std::string::npos);
}

TEST(MarkerCommand, SaysWhatIsWrong) {
    const test::TemporaryFolder folder;
    const auto file = folder.write("halves.json", kNested);
    const auto wide = test::toileRun({"marker", file.string(), "--border", "1", "--rounds", "1"});
    EXPECT_EQ(wide.status, 3);
    EXPECT_NE(wide.err.find("does not fit"), std::string::npos) << wide.err;
    EXPECT_EQ(test::toileRun({"marker", "dress.obj"}).status, 2);
    EXPECT_EQ(test::toileRun({"marker", file.string(), "-o", "nest.pdf"}).status, 2);
    EXPECT_EQ(test::toileRun({"marker", (folder / "none.json").string()}).status, 3);
}

}  // namespace
}  // namespace toile
