// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/zip_reader.h"

#include <set>

#include <gtest/gtest.h>

#include "core/base/id.h"
#include "tests/core/io/soup_checks.h"
#include "tests/core/io/zip_archive.h"
#include "tests/core/support/temporary_folder.h"

namespace toile::test {
namespace {

constexpr const char* kSquare =
    "mtllib shirt.mtl\no shirt\nusemtl denim\nv 0 0 0\nv 1.50 0 0\nv 1.50 2 0\nv 0 2 0\n"
    "f 1 2 3 4\n";

class ZippedMesh : public testing::Test {
protected:
    Result<PolygonSoup> readAs(const std::vector<ZipEntry>& entries,
                               const std::string& fileName = "shirt.zip") {
        return readBytes(zipOf(entries), fileName);
    }

    Result<PolygonSoup> readBytes(const std::string& bytes, const std::string& fileName) {
        Progress progress;
        return readSoup(folder_.write(fileName, bytes), progress);
    }

    TemporaryFolder folder_;
};

TEST_F(ZippedMesh, IsReadAsTheFileItself) {
    const std::vector<ZipEntry> entries = {
        {"shirt/", ""}, {"shirt/shirt.mtl", "newmtl denim\n"}, {"shirt/shirt.OBJ", kSquare}};
    for (const char* fileName : {"shirt.zip", "shirt.ZIP"}) {
        const auto soup = readAs(entries, fileName);
        ASSERT_TRUE(soup) << sentence(soup.error());
        expectValid(*soup);
        EXPECT_EQ(soup->objects, std::vector<std::string>{"shirt"});
        EXPECT_EQ(soup->materials, std::vector<std::string>{"denim"});
        EXPECT_EQ(soup->positions[2], Eigen::Vector3d(1.5, 2, 0));
        ASSERT_TRUE(soup->text);  // the file's own digits go along
        EXPECT_EQ(soup->text->substr(soup->positionText[1].offset, 4), "1.50");
    }
}

TEST_F(ZippedMesh, IsKnownByTheHashOfTheArchive) {
    const std::string archive = zipOf({{"a.obj", kSquare}});
    EXPECT_EQ(readBytes(archive, "a.zip")->contentHash, contentHash(archive));
}

TEST_F(ZippedMesh, MayBeOfEveryFormatOfOurOwn) {
    EXPECT_TRUE(readAs({{"a.off", sampleOff()}, {"read me.txt", "hello"}}));
    EXPECT_TRUE(readAs({{"a.ply", samplePlyBinary()}}));
    EXPECT_TRUE(readAs({{"a.stl", sampleStlBinary()}}));
}

TEST_F(ZippedMesh, TheOnlyObjIsTakenAmongOthers) {
    const auto soup = readAs({{"shirt.stl", sampleStlAscii()},
                              {"shirt.obj", kSquare},
                              {"__MACOSX/._shirt.obj", "resources"},
                              {".hidden.obj", "v"}});
    ASSERT_TRUE(soup) << sentence(soup.error());
    EXPECT_EQ(soup->faceCount(), 1);
}

TEST_F(ZippedMesh, NamesThatLeadOutOfTheArchiveMeanNothing) {
    for (const char* name : {"../../outside.obj", "/outside.obj", "a/../../outside.obj"}) {
        EXPECT_TRUE(readAs({{name, kSquare}})) << name;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "outside.obj"));
        EXPECT_FALSE(std::filesystem::exists(folder_ / "../outside.obj"));
    }
}

TEST_F(ZippedMesh, SeveralAreOneGarment) {
    constexpr const char* kWithoutNames =
        "v 0 0 9\nv 1 0 9\nv 1 1 9\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n";
    const auto soup = readAs({{"parts/front.obj", kSquare},
                              {"parts/back.obj", kSquare},
                              {"parts/yoke.obj", kWithoutNames},
                              {"all.stl", sampleStlAscii()}});
    ASSERT_TRUE(soup) << sentence(soup.error());
    expectValid(*soup);
    EXPECT_EQ(soup->faceCount(), 3);
    EXPECT_EQ(soup->positions.size(), 11U);
    EXPECT_EQ(soup->objects, (std::vector<std::string>{"shirt", "back shirt", "yoke"}));
    EXPECT_EQ(soup->faceObject, (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(soup->materials, std::vector<std::string>{"denim"});
    EXPECT_EQ(soup->faceMaterial, (std::vector<int>{0, 0, -1}));
    EXPECT_EQ(soup->corners, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
    EXPECT_EQ(soup->cornerUvs, (std::vector<int>{-1, -1, -1, -1, -1, -1, -1, -1, 0, 1, 2}));
    // What befalls one of them befalls the archive.
    EXPECT_FALSE(readAs({{"front.obj", kSquare}, {"back.obj", kSquare, true}}));
    EXPECT_FALSE(readAs({{"front.obj", kSquare}, {"back.obj", "no mesh"}}));
}

TEST_F(ZippedMesh, ObjectsOfOneNameInFilesOfOneNameStayApart) {
    const auto soup =
        readAs({{"a/shirt.obj", kSquare},
                {"b/shirt.obj", kSquare},
                {"c/shirt.obj", kSquare},
                {"d/shirt.obj", "o shirt shirt\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"}});
    ASSERT_TRUE(soup) << sentence(soup.error());
    EXPECT_EQ(soup->faceObject, (std::vector<int>{0, 1, 2, 3}));
    EXPECT_EQ(std::set<std::string>(soup->objects.begin(), soup->objects.end()).size(), 4U);
}

TEST_F(ZippedMesh, ReadingTellsHowManyOfTheMeshesAreRead) {
    Progress progress, broken;
    ASSERT_TRUE(readSoup(folder_.write("a.zip", zipOf({{"a.obj", kSquare}, {"b.obj", kSquare}})),
                         progress));
    EXPECT_EQ(progress.fraction(), 1);
    const std::string half = zipOf({{"a.obj", kSquare}, {"b.obj", "no mesh"}});
    ASSERT_FALSE(readSoup(folder_.write("b.zip", half), broken));
    EXPECT_EQ(broken.fraction(), 0.5);
}

TEST_F(ZippedMesh, SeveralOfDifferentUnitsAreRefused) {
    const auto usd = [](const std::string& metres) {
        return "#usda 1.0\n(\n metersPerUnit = " + metres +
               "\n)\ndef Mesh \"m\" {\n int[] faceVertexCounts = [3]\n"
               " int[] faceVertexIndices = [0, 1, 2]\n"
               " point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]\n}\n";
    };
    EXPECT_TRUE(readAs({{"a.usda", usd("0.01")}, {"b.usda", usd("0.01")}}));
    const auto soup = readAs({{"a.usda", usd("0.01")}, {"b.usda", usd("1")}});
    ASSERT_FALSE(soup);
    EXPECT_NE(sentence(soup.error()).find("unpack it"), std::string::npos);
}

TEST_F(ZippedMesh, WhatHoldsNoneSaysWhatIsLookedFor) {
    for (const std::vector<ZipEntry>& entries :
         {std::vector<ZipEntry>{}, {{"read me.txt", "hello"}}, {{"obj", kSquare}}}) {
        const auto soup = readAs(entries);
        ASSERT_FALSE(soup);
        EXPECT_EQ(soup.error().code, ErrorCode::NoGeometry);
        EXPECT_NE(soup.error().detail.find(".obj"), std::string::npos);
    }
}

TEST_F(ZippedMesh, AnEncryptedOneIsSaidToBe) {
    const auto soup = readAs({{"a.obj", kSquare, true}});
    ASSERT_FALSE(soup);
    EXPECT_EQ(soup.error().code, ErrorCode::FileUnreadable);
    EXPECT_NE(soup.error().detail.find("encrypted"), std::string::npos);
}

TEST_F(ZippedMesh, BombsAreRefusedBeforeTheyAreUnpacked) {
    const auto large = readAs({{"a.obj", kSquare, false, 0xF0000000U, 8}});
    ASSERT_FALSE(large);
    EXPECT_EQ(large.error().code, ErrorCode::FileUnreadable);
    EXPECT_NE(large.error().detail.find("too large"), std::string::npos);
    const auto tight = readAs({{"a.obj", kSquare, false, 0x20000000U, 8}});
    ASSERT_FALSE(tight);
    EXPECT_EQ(tight.error().code, ErrorCode::FileUnreadable);
    EXPECT_NE(tight.error().detail.find("too large"), std::string::npos);
}

TEST_F(ZippedMesh, ManySmallEntriesAddUp) {
    std::vector<ZipEntry> entries;
    for (int k = 0; k < 100; ++k) {
        entries.push_back({std::to_string(k) + ".obj", kSquare, false, 1'000'000, 8});
    }
    const auto soup = readAs(entries);
    ASSERT_FALSE(soup);
    EXPECT_EQ(soup.error().code, ErrorCode::FileUnreadable);
    EXPECT_NE(soup.error().detail.find("too large"), std::string::npos);
}

TEST_F(ZippedMesh, TooManyEntriesAreRefused) {
    const std::vector<ZipEntry> many(io::kMaxZipEntries + 1, {"a.txt", ""});
    const auto soup = readAs(many);
    ASSERT_FALSE(soup);
    EXPECT_EQ(soup.error().code, ErrorCode::FileUnreadable);
}

TEST_F(ZippedMesh, DamagedArchivesAreReadOrRefused) {
    const std::string archive = zipOf({{"a.obj", kSquare}, {"b.txt", "hello"}});
    for (std::size_t length = 0; length < archive.size(); ++length) {
        EXPECT_FALSE(readBytes(archive.substr(0, length), "a.zip")) << length;
    }
    for (std::size_t k = 0; k < archive.size(); ++k) {
        std::string changed = archive;
        changed[k] = static_cast<char>(changed[k] ^ 0x5A);
        const auto soup = readBytes(changed, "a.zip");
        if (soup) {
            expectValid(*soup);
        } else {
            EXPECT_FALSE(soup.error().detail.empty()) << k;
        }
    }
}

TEST_F(ZippedMesh, IsLeftWhereThatIsAskedFor) {
    Progress progress;
    progress.cancel();
    const auto soup = readSoup(folder_.write("a.zip", zipOf({{"a.obj", kSquare}})), progress);
    ASSERT_FALSE(soup);
    EXPECT_EQ(soup.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace toile::test
