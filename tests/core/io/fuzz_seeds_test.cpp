// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the fuzz targets' seeds, among them the reduced form of everything fuzzing has found, in
// every build and not only with Clang.
#include <filesystem>

#include <gtest/gtest.h>

#include "core/base/file.h"
#include "tests/fuzz/check_garment.h"
#include "tests/fuzz/check_reader.h"

namespace toile::fuzz {
namespace {

namespace fs = std::filesystem;

struct Target {
    const char* format;
    ReadFunction reader;
};

class ReaderSeeds : public testing::TestWithParam<Target> {};

TEST_P(ReaderSeeds, BreakNoPromise) {
    const fs::path folder = fs::path(TOILE_SOURCE_DIR) / "tests/fuzz/seeds" / GetParam().format;
    int seeds = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const Result<std::string> bytes = readFile(entry.path());
        ASSERT_TRUE(bytes) << sentence(bytes.error());
        EXPECT_EQ(whatBreaks(GetParam().reader, *bytes), "") << entry.path().filename();
        ++seeds;
    }
    EXPECT_GE(seeds, 10);
}

TEST(FuzzSeeds, BreakNoPromiseOnTheWholeRoad) {
    for (const char* folder : {"off", "garment"}) {
        const fs::path seeds = fs::path(TOILE_SOURCE_DIR) / "tests/fuzz/seeds" / folder;
        for (const auto& entry : fs::directory_iterator(seeds)) {
            const Result<std::string> bytes = readFile(entry.path());
            ASSERT_TRUE(bytes) << sentence(bytes.error());
            EXPECT_EQ(whatBreaksOnTheWay(*bytes), "") << entry.path().filename();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(AllFormats, ReaderSeeds,
                         testing::Values(Target{"obj", readObj}, Target{"off", readOff},
                                         Target{"ply", readPly}, Target{"stl", readStl}),
                         [](const auto& test) { return std::string(test.param.format); });

}  // namespace
}  // namespace toile::fuzz
