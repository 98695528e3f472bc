// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the fuzz targets' seeds, among them the reduced form of everything fuzzing has found, in
// every build and not only with Clang.
#include <filesystem>

#include <gtest/gtest.h>

#include "core/base/file.h"
#include "tests/core/support/shared_data.h"
#include "tests/fuzz/check_garment.h"
#include "tests/fuzz/targets.h"

namespace toile::fuzz {
namespace {

namespace fs = std::filesystem;

/// Gives every seed of a folder to a check; how many there are.
int runSeeds(const std::string& folder, std::string (*whatBreaks)(std::string)) {
    int seeds = 0;
    for (const auto& entry :
         fs::directory_iterator(test::sourceFile("tests/fuzz/seeds") / folder)) {
        const Result<std::string> bytes = readFile(entry.path());
        EXPECT_TRUE(bytes);
        EXPECT_EQ(whatBreaks(bytes ? *bytes : ""), "") << entry.path().filename();
        ++seeds;
    }
    return seeds;
}

class FuzzSeeds : public testing::TestWithParam<Target> {};

TEST_P(FuzzSeeds, BreakNoPromise) {
    const std::string name = GetParam().name;
    EXPECT_GE(runSeeds(name, GetParam().whatBreaks),
              name == "garment" || name == "prepare" ? 5 : 10);
}

TEST(ReaderSeeds, BreakNoPromiseOnTheWholePipeline) {
    EXPECT_GE(runSeeds("off", whatBreaksOnTheWay), 10);
}

INSTANTIATE_TEST_SUITE_P(AllTargets, FuzzSeeds, testing::ValuesIn(targets()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace toile::fuzz
