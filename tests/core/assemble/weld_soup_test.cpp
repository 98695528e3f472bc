// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/weld_soup.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace toile {
namespace {

/// A strip of unit squares, each of two triangles with corners of their own.
PolygonSoup looseStrip(int squares, bool inTwoObjects = false) {
    PolygonSoup soup;
    for (int k = 0; k < squares; ++k) {
        const double x = k;
        for (const auto& [a, b] :
             {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
            soup.corners.push_back(static_cast<int>(soup.positions.size()));
            soup.positions.emplace_back(x + a, b, 0);
        }
        for (int t = 0; t < 2; ++t) {
            soup.faceStart.push_back(soup.faceStart.back() + 3);
            if (inTwoObjects) {
                soup.faceObject.push_back(k < squares / 2 ? 0 : 1);
            }
        }
    }
    if (inTwoObjects) {
        soup.objects = {"left", "right"};
    }
    return soup;
}

Problems weld(PolygonSoup& soup, bool wanted, double millimetres) {
    auto shared = std::make_shared<const PolygonSoup>(soup);
    Problems notes =
        weldSoup(shared, wanted ? std::optional(0.0) : std::nullopt, millimetres, "a.obj");
    soup = *shared;
    return notes;
}

std::size_t verticesUsed(const PolygonSoup& soup) {
    std::vector<int> corners = soup.corners;
    std::sort(corners.begin(), corners.end());
    return static_cast<std::size_t>(std::unique(corners.begin(), corners.end()) - corners.begin());
}

TEST(WeldSoup, JoinsAFileOfLooseTrianglesWithoutBeingAsked) {
    PolygonSoup soup = looseStrip(10);
    const Problems notes = weld(soup, false, 10);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, ErrorCode::VerticesWelded);
    EXPECT_EQ(verticesUsed(soup), 22U);
    EXPECT_EQ(soup.positions.size(), 60U);
}

TEST(WeldSoup, StaysWithinAnObject) {
    PolygonSoup soup = looseStrip(10, true);
    weld(soup, true, 1);
    EXPECT_EQ(verticesUsed(soup), 24U);
}

TEST(WeldSoup, TakesObjectsThatShareVerticesAndFacesOfNone) {
    PolygonSoup soup = looseStrip(4);
    soup.objects = {"a", "b"};
    soup.faceObject = {-1, -1, 0, 0, 1, 1, 0, 0};
    soup.corners[12] = soup.corners[9];  // b uses a vertex that a joins to another
    weld(soup, true, 1);
    const std::vector<int>& corners = soup.corners;
    EXPECT_EQ(corners[3], corners[0]);  // of no object: its two triangles are joined
    EXPECT_EQ(corners[9], corners[6]);  // of a
    EXPECT_EQ(corners[12], 9);          // of b: nothing of b lies there
    EXPECT_NE(corners[6], corners[1]);  // of a and of none: they stay apart
}

TEST(WeldSoup, LeavesAFileWithPiecesApartAloneUnlessAsked) {
    PolygonSoup soup;
    soup.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                      {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 1e-5}};
    soup.corners = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    soup.faceStart = {0, 3, 6, 9, 12};
    const std::vector<int> before = soup.corners;
    EXPECT_TRUE(weld(soup, false, 1).empty());
    EXPECT_EQ(soup.corners, before);
    EXPECT_EQ(weld(soup, true, 1).size(), 1U);  // 1e-5: digits written
    EXPECT_EQ(verticesUsed(soup), 6U);
}

TEST(WeldSoup, AQuadWhoseCornersMeetBecomesATriangle) {
    PolygonSoup soup;
    soup.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 1, 0}, {-1, 0, 0}};
    soup.corners = {0, 1, 2, 3, 0, 3, 4};
    soup.faceStart = {0, 4, 7};
    soup.cornerUvs = {0, 1, 2, 3, 0, 3, 4};
    soup.uvs.resize(5, Eigen::Vector2d::Zero());
    weld(soup, true, 1);
    EXPECT_EQ(soup.faceStart, (std::vector<int>{0, 3, 6}));
    EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2, 0, 2, 4}));
    EXPECT_EQ(soup.cornerUvs.size(), soup.corners.size());
}

}  // namespace
}  // namespace toile
