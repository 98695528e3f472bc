// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/file_surface.h"

#include <limits>
#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace toile {
namespace {

PolygonSoup read(const char* text) {
    Progress progress;
    return *readObj(std::make_shared<const std::string>(text), "a.obj", progress);
}

constexpr const char* kTwoFaces =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
    "o front\nf 1/1 2/2 3/3 4/1\no back\nf 2/1 5/2 3/3\n";

TEST(FileSurface, HasTheFilesNumbersInMillimetres) {
    const FileSurface surface = surfaceOf(read(kTwoFaces), 10);
    EXPECT_EQ(surface.mesh.V.rows(), 5);
    EXPECT_EQ(surface.mesh.V(4, 0), 20);
    EXPECT_EQ(surface.face, (std::vector<int>{0, 0, 1}));
}

TEST(FileSurface, PassesOverPositionsThatAreNoNumbers) {
    PolygonSoup soup = read(kTwoFaces);
    soup.positions[4].x() = std::numeric_limits<double>::quiet_NaN();
    const FileSurface surface = surfaceOf(soup, 1);
    EXPECT_EQ(surface.face, (std::vector<int>{0, 0}));
    EXPECT_TRUE(surface.mesh.V.allFinite());
}

TEST(FileSurface, FacesTakenAloneKeepNamesAndMap) {
    const PolygonSoup soup = read(kTwoFaces);
    const PolygonSoup kept = withFaces(soup, {1});
    EXPECT_EQ(kept.faceCount(), 1);
    EXPECT_EQ(kept.corners, (std::vector<int>{1, 4, 2}));
    EXPECT_EQ(kept.cornerUvs, (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(kept.objects[static_cast<std::size_t>(kept.faceObject[0])], "back");
    EXPECT_EQ(withFaces(soup, {0, 1}).corners, soup.corners);
}

}  // namespace
}  // namespace toile
