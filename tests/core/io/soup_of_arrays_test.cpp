// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh in memory gives the soup that a reader makes of the file with it.
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/io/soup_builder.h"
#include "tests/core/io/soup_checks.h"

namespace toile::test {
namespace {

const std::vector<double> kFivePoints{0, 0, 0, 1, 0, 0, 2.5, 0, 0, 0, 1, 0, 1, 1, 0};
const std::vector<int> kQuadAndTriangle{0, 4, 7}, kSevenCorners{0, 1, 4, 3, 1, 2, 4};

TEST(SoupOfArrays, IsThatOfTheFile) {
    const std::vector<double> uvs{0, 0, 1, 0, 1, 1};
    const std::vector<int> cornerUvs{0, 1, 2, 2, -1, -1, -1}, names{1, 0}, none{-1, 0};
    const auto soup = soupOfArrays({.positions = kFivePoints,
                                    .uvs = uvs,
                                    .faceStart = kQuadAndTriangle,
                                    .corners = kSevenCorners,
                                    .cornerUvs = cornerUvs,
                                    .objects = {{"back", "front"}, names},
                                    .groups = {{"hem"}, none},
                                    .decimals = 2},
                                   "tee");
    ASSERT_TRUE(soup.ok());
    const PolygonSoup file =
        readValid(readObj,
                  "v 0.00 0.00 0.00\nv 1.00 0.00 0.00\nv 2.50 0.00 0.00\nv 0.00 1.00 0.00\n"
                  "v 1.00 1.00 0.00\nvt 0 0\nvt 1 0\nvt 1 1\no front\nf 1/1 2/2 5/3 4/3\n"
                  "o back\ng hem\nf 2 3 5\n");
    expectSameMesh(*soup, file);
    EXPECT_TRUE(soup->materials.empty() && soup->faceMaterial.empty());
    ASSERT_EQ(soup->positionText.size(), file.positionText.size());
    for (int k = 0; k < 5; ++k) {
        EXPECT_EQ(positionText(*soup, k), positionText(file, k));
    }
}

TEST(SoupOfArrays, ListsWhatItLeavesOut) {
    std::vector<double> positions = kFivePoints;
    positions[6] = std::numeric_limits<double>::quiet_NaN();
    const std::vector<int> starts{0, 3, 5, 8}, corners{0, 1, 99, 0, 1, 0, 1, 4};
    const auto soup =
        soupOfArrays({.positions = positions, .faceStart = starts, .corners = corners}, "tee");
    ASSERT_TRUE(soup.ok());
    EXPECT_EQ(face(*soup, 0), (std::vector<int>{0, 1, 4}));
    EXPECT_EQ(soup->faceCount(), 1);
    std::vector<ErrorCode> codes;
    for (const Error& problem : soup->problems) {
        codes.push_back(problem.code);
        EXPECT_EQ(problem.subject, Subject::file("tee"));
    }
    EXPECT_EQ(codes, (std::vector{ErrorCode::NonFinitePosition, ErrorCode::DegenerateFaceRecord,
                                  ErrorCode::IndexOutOfRange}));
    const auto none = soupOfArrays({.positions = positions, .faceStart = {}, .corners = {}}, "tee");
    ASSERT_FALSE(none.ok());
    EXPECT_EQ(none.error().code, ErrorCode::NoGeometry);
}

TEST(SoupOfArrays, HashTellsMeshesApart) {
    MeshInArrays mesh{
        .positions = kFivePoints, .faceStart = kQuadAndTriangle, .corners = kSevenCorners};
    const auto hash = [&mesh] { return soupOfArrays(mesh, "tee")->contentHash; };
    const auto before = hash();
    EXPECT_EQ(hash(), before);
    std::vector<double> moved = kFivePoints;
    moved[0] = 0.1;
    mesh.positions = moved;
    EXPECT_NE(hash(), before);
}

}  // namespace
}  // namespace toile::test
