// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "core/io/soup.h"
#include "core/io/triangulate.h"
#include "tests/core/io/soup_checks.h"

namespace toile::test {
namespace {

/// Whatever a reader gets, it either refuses with a reason or gives a valid soup.
void expectValidOrRefused(ReadFunction reader, const std::string& bytes) {
    const Result<PolygonSoup> soup = read(reader, bytes);
    if (!soup) {
        EXPECT_TRUE(soup.error().code == ErrorCode::MalformedFile ||
                    soup.error().code == ErrorCode::NoGeometry);
        EXPECT_FALSE(soup.error().detail.empty());
        return;
    }
    expectValid(*soup);
    const Triangulation triangles = triangulate(*soup, "test");
    ASSERT_EQ(triangles.F.rows(), static_cast<Eigen::Index>(triangles.sourceFace.size()));
    if (triangles.F.size() > 0) {
        ASSERT_GE(triangles.F.minCoeff(), 0);
        ASSERT_LT(triangles.F.maxCoeff(), static_cast<int>(soup->positions.size()));
    }
}

struct Format {
    const char* name;
    ReadFunction reader;
    std::string (*sample)();
};

class DamagedFile : public testing::TestWithParam<Format> {};

TEST_P(DamagedFile, EveryPrefixIsReadOrRefused) {
    const std::string sample = GetParam().sample();
    for (std::size_t length = 0; length <= sample.size(); ++length) {
        expectValidOrRefused(GetParam().reader, sample.substr(0, length));
        ASSERT_FALSE(HasFailure()) << "prefix of " << length << " bytes";
    }
}

TEST_P(DamagedFile, RandomBytesAreReadOrRefused) {
    std::mt19937 random(20240607);
    const std::string sample = GetParam().sample();
    const std::string likely = "0123456789-+.eE/\\# \t\r\n\"vftnagPLYOFF,\xFF\x80";
    for (int round = 0; round < 4000; ++round) {
        std::string bytes = sample;
        for (unsigned changes = 1 + random() % 6; changes > 0; --changes) {
            const std::size_t at = random() % bytes.size();
            const char any = static_cast<char>(random());
            const char c = random() % 3 == 0 ? any : likely[random() % likely.size()];
            switch (random() % 4) {
                case 0:
                    bytes.insert(at, 1, c);
                    break;
                case 1:
                    bytes.erase(at, 1 + random() % 5);
                    break;
                default:
                    bytes[at] = c;
            }
            bytes += bytes.empty() ? "x" : "";
        }
        expectValidOrRefused(GetParam().reader, bytes);
        ASSERT_FALSE(HasFailure()) << "round " << round;
    }
}

TEST_P(DamagedFile, PureNoiseIsReadOrRefused) {
    std::mt19937 random(7);
    for (int round = 0; round < 500; ++round) {
        std::string bytes(random() % 400, '\0');
        for (char& c : bytes) {
            c = static_cast<char>(random());
        }
        expectValidOrRefused(GetParam().reader, bytes);
        ASSERT_FALSE(HasFailure()) << "round " << round;
    }
}

INSTANTIATE_TEST_SUITE_P(AllFormats, DamagedFile,
                         testing::Values(Format{"Obj", readObj, sampleObj},
                                         Format{"Off", readOff, sampleOff},
                                         Format{"PlyAscii", readPly, samplePlyAscii},
                                         Format{"PlyBinary", readPly, samplePlyBinary},
                                         Format{"StlAscii", readStl, sampleStlAscii},
                                         Format{"StlBinary", readStl, sampleStlBinary}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace toile::test
