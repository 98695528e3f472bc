// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <optional>
#include <set>

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

}  // namespace
}  // namespace toile
