// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "core/prepare/shell.h"
#include "tests/core/prepare/thick_shapes.h"

namespace toile {
namespace {

using namespace test;

TEST(SheetOf, TheMiddleLiesHalfTheWay) {
    const PolygonSoup sheet = tubeSheet();
    for (const PolygonSoup& soup : {thickened(sheet), looseSoup(thickened(sheet))}) {
        const FileSurface surface = surfaceOf(soup, 10);  // the soup's own unit is kept
        const auto shell = findShell(surface, Progress());
        ASSERT_TRUE(shell);
        const PolygonSoup middle = sheetOf(soup, surface, *shell, ShellSurface::Middle);
        for (const int corner : middle.corners) {
            ASSERT_NEAR(middle.positions[corner].cwiseProduct(Eigen::Vector3d(1, 0, 1)).norm(),
                        50 - 0.75, 1e-3);
        }
        // What was closed stays so.
        std::set<std::array<double, 3>> places;
        for (const int corner : middle.corners) {
            const Eigen::Vector3d& at = middle.positions[corner];
            places.insert({at.x(), at.y(), at.z()});
        }
        EXPECT_EQ(places.size(), sheet.positions.size());
    }
}

TEST(SheetOf, TheMiddleOfSurfacesDividedDifferently) {
    const PolygonSoup soup = tubeInTube(100, 90, 98, 61);
    const FileSurface surface = surfaceOf(soup, 1);
    const auto shell = findShell(surface, Progress());
    ASSERT_TRUE(shell);
    const PolygonSoup middle = sheetOf(soup, surface, *shell, ShellSurface::Middle);
    for (const int corner : middle.corners) {
        ASSERT_NEAR(middle.positions[corner].head<2>().norm(), 99, 0.1);
    }
}

/// Whatever happens to a file: each face is kept or in one list of those left out.
TEST(SheetOf, PartsTheFacesOfBrokenFilesToo) {
    const PolygonSoup whole = thickened(weldedSoup(shirtSample()));
    int shells = 0;
    for (unsigned seed = 0; seed < 12; ++seed) {
        std::mt19937 random(seed);
        const auto oneOf = [&random](std::uint32_t many) { return random() % many == 0; };
        PolygonSoup soup = whole;
        const std::uint32_t rarely = 1U << (seed + 2);
        std::vector<int> kept;
        for (int face = 0; face < soup.faceCount(); ++face) {
            if (!oneOf(rarely)) {
                kept.push_back(face);
            }
            if (oneOf(rarely)) {
                soup.corners[soup.faceStart[face]] = soup.corners[random() % soup.corners.size()];
            }
        }
        soup = withFaces(soup, kept);
        const FileSurface surface = surfaceOf(soup, 1);
        const auto shell = findShell(surface, Progress());
        if (!shell) {
            continue;
        }
        ++shells;
        for (const ShellSurface which :
             {ShellSurface::Outer, ShellSurface::Inner, ShellSurface::Middle}) {
            const PolygonSoup sheet = sheetOf(soup, surface, *shell, which);
            const LeftOut left = leftOut(surface, *shell, which);
            const std::set<int> faces(surface.face.begin(), surface.face.end());
            EXPECT_EQ(
                static_cast<std::size_t>(sheet.faceCount()) + left.other.size() + left.rims.size(),
                faces.size());
        }
    }
    EXPECT_GE(shells, 4);
}

}  // namespace
}  // namespace toile
