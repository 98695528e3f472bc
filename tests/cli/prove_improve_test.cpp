// SPDX-License-Identifier: GPL-3.0-or-later
// `toile prove --prove-improve`, with the built program.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/formats/read_pattern.h"
#include "tests/cli/run_program.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

test::ProgramRun improveCap(std::vector<std::string> more) {
    std::vector<std::string> words{"prove", test::sourceFile("resources/samples/cap.obj").string(),
                                   "--unit", "mm"};
    words.insert(words.end(), more.begin(), more.end());
    return test::toileRun(words);
}

TEST(ProveImprove, SaysWhatEachRoundGainsAndWritesThePattern) {
    const test::TemporaryFolder folder;
    const auto file = folder / "improved.dxf";
    const auto run = improveCap({"--gravity", "--pressure", "0.5", "--stretch", "30", "--rounds",
                                 "1", "--prove-improve", "-o", file.string()});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(run.out.starts_with("before: ")) << run.out;
    for (const char* said : {"\nround 1: ", "mproved", "\nThe sewn pattern is ", "\nwrote "}) {
        EXPECT_NE(run.out.find(said), std::string::npos) << said << '\n' << run.out;
    }
    EXPECT_TRUE(readPatternFile(file, {}));
}

TEST(ProveImprove, IsOfTheGarmentsOwnPattern) {
    EXPECT_EQ(improveCap({"--prove-improve", "--reference", "uv"}).status, 2);
    EXPECT_EQ(improveCap({"--prove-improve", "--pattern", "a.svg"}).status, 2);
    EXPECT_EQ(improveCap({"--rounds", "3"}).status, 2);
    EXPECT_EQ(improveCap({"-o", "improved.dxf"}).status, 2);
    EXPECT_EQ(improveCap({"--prove-improve", "-o", "improved.xyz"}).status, 2);
}

}  // namespace
}  // namespace toile
