// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/soup.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/core/io/soup_checks.h"

namespace toile::test {
namespace {

namespace fs = std::filesystem;

class ReadSoup : public testing::Test {
protected:
    ReadSoup() {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(testing::TempDir()) / ("toile_" + std::string(info->name()));
        fs::create_directories(folder_);
    }

    ~ReadSoup() override { fs::remove_all(folder_); }

    Result<PolygonSoup> readAs(const std::string& fileName, const std::string& bytes) {
        std::ofstream(folder_ / fileName, std::ios::binary) << bytes;
        Progress progress;
        return readSoup(folder_ / fileName, progress);
    }

    fs::path folder_;
};

TEST_F(ReadSoup, ChoosesTheReaderByTheEnding) {
    const std::pair<const char*, std::string> files[] = {
        {"a.obj", sampleObj()},       {"a.OFF", sampleOff()},      {"a.b.Ply", samplePlyAscii()},
        {"b.ply", samplePlyBinary()}, {"a.stl", sampleStlAscii()}, {"b.STL", sampleStlBinary()}};
    for (const auto& [fileName, bytes] : files) {
        const Result<PolygonSoup> soup = readAs(fileName, bytes);
        ASSERT_TRUE(soup) << fileName;
        EXPECT_EQ(soup->positions.size(), 4u) << fileName;
        expectValid(*soup);
    }
}

TEST_F(ReadSoup, RefusesOtherEndings) {
    for (const char* fileName : {"a.blend", "obj", "a.obj.txt", ".obj"}) {
        const Result<PolygonSoup> soup = readAs(fileName, sampleObj());
        ASSERT_FALSE(soup) << fileName;
        EXPECT_EQ(soup.error().code, ErrorCode::UnknownFormat) << fileName;
        EXPECT_EQ(soup.error().subject.name, fileName);
    }
}

TEST_F(ReadSoup, SaysOfAFolderAndOfNothingThatItIsThat) {
    Progress progress;
    fs::create_directories(folder_ / "meshes");
    fs::create_directories(folder_ / "meshes.obj");
    for (const char* folder : {"meshes", "meshes.obj", "."}) {
        const Result<PolygonSoup> soup = readSoup(folder_ / folder, progress);
        ASSERT_FALSE(soup) << folder;
        EXPECT_EQ(soup.error().code, ErrorCode::FileUnreadable) << folder;
        EXPECT_EQ(soup.error().detail, "it is a folder") << folder;
    }
    for (const char* missing : {"a.blend", "obj", "a.dxf"}) {
        const Result<PolygonSoup> soup = readSoup(folder_ / missing, progress);
        ASSERT_FALSE(soup) << missing;
        EXPECT_EQ(soup.error().code, ErrorCode::FileUnreadable) << missing;
        EXPECT_EQ(soup.error().detail, "there is no such file") << missing;
    }
}

TEST_F(ReadSoup, SaysOfAPatternThatItIsOne) {
    for (const char* fileName : {"skirt.dxf", "skirt.SVG", "skirt_specification.json"}) {
        const Result<PolygonSoup> soup = readAs(fileName, "0\nSECTION\n");
        ASSERT_FALSE(soup) << fileName;
        EXPECT_EQ(soup.error().code, ErrorCode::UnknownFormat) << fileName;
        EXPECT_NE(soup.error().detail.find("pattern"), std::string::npos) << fileName;
    }
    EXPECT_EQ(readAs("report.json", "{}").error().code, ErrorCode::UnknownFormat);
}

TEST_F(ReadSoup, RefusesWhatCannotBeRead) {
    Progress progress;
    const Result<PolygonSoup> soup = readSoup(folder_ / "missing.obj", progress);
    ASSERT_FALSE(soup);
    EXPECT_EQ(soup.error().code, ErrorCode::FileUnreadable);
}

TEST_F(ReadSoup, NamesTheFileInMessages) {
    const Result<PolygonSoup> soup = readAs("blouse.obj", "v 0 0 0\n");
    ASSERT_FALSE(soup);
    EXPECT_EQ(soup.error().subject.name, "blouse.obj");
}

}  // namespace
}  // namespace toile::test
