// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/shell.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/core/prepare/thick_shapes.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using namespace test;

std::optional<Shell> shellOf(const PolygonSoup& soup, double millimetres = 1) {
    return findShell(surfaceOf(soup, millimetres), Progress());
}

/// Runs every face the other way, those from `first` on.
PolygonSoup turnedFrom(PolygonSoup soup, int first) {
    for (int face = first; face < soup.faceCount(); ++face) {
        std::reverse(soup.corners.begin() + soup.faceStart[face] + 1,
                     soup.corners.begin() + soup.faceStart[face + 1]);
    }
    return soup;
}

TEST(FindShell, SaysHowThick) {
    const auto one = shellOf(thickened(tubeSheet()));
    ASSERT_TRUE(one);
    EXPECT_NEAR(one->median, 1.5, 0.01);
    EXPECT_NEAR(one->thinnest, 1.5, 0.01);
    EXPECT_NEAR(one->thickest, 1.5, 0.01);
    const auto collar = [](const Eigen::Vector3d& position) {
        return position.y() > 300 ? 3.0 : 1.0;
    };
    const auto two = shellOf(thickened(tubeSheet(), {.thickness = collar}));
    ASSERT_TRUE(two);
    EXPECT_NEAR(two->thinnest, 1, 0.01);
    EXPECT_NEAR(two->thickest, 3, 0.02);
    const auto inCentimetres = shellOf(thickened(tubeSheet()), 10);
    ASSERT_TRUE(inCentimetres);
    EXPECT_NEAR(inCentimetres->median, 15, 0.1);
}

TEST(FindShell, KnowsEachVertexByItsCopy) {
    const PolygonSoup sheet = tubeSheet();
    const auto shell = shellOf(thickened(sheet));
    ASSERT_TRUE(shell);
    const int count = static_cast<int>(sheet.positions.size());
    for (int v = 0; v < count; ++v) {
        ASSERT_EQ(shell->partner[v], v + count);
        ASSERT_EQ(shell->partner[v + count], v);
    }
}

TEST(FindShell, StandsSurfacesThatLookTheOtherWay) {
    const PolygonSoup sheet = tubeSheet();
    const PolygonSoup soup = thickened(sheet, {.rims = false});
    for (const PolygonSoup& turned : {turnedFrom(soup, 0), turnedFrom(soup, sheet.faceCount())}) {
        const FileSurface surface = surfaceOf(turned, 1);
        const auto shell = findShell(surface, Progress());
        ASSERT_TRUE(shell);
        EXPECT_EQ(sheetOf(turned, surface, *shell, ShellSurface::Outer).corners, sheet.corners);
    }
}

TEST(FindShell, FollowsSurfacesThatAreDividedDifferently) {
    const PolygonSoup soup = tubeInTube(100, 90, 98, 61);
    const FileSurface surface = surfaceOf(soup, 1);
    const auto shell = findShell(surface, Progress());
    ASSERT_TRUE(shell);
    const int outer = 90 * 30 * 2, inner = 61 * 20 * 2;
    for (int t = 0; t < std::ssize(shell->side); ++t) {
        ASSERT_EQ(shell->side[t], t < outer           ? ShellSide::Outer
                                  : t < outer + inner ? ShellSide::Inner
                                                      : ShellSide::Rim)
            << t;
    }
    EXPECT_NEAR(shell->median, 2, 0.15);
}

TEST(FindShell, FollowsAnInnerSurfaceThatIsFiner) {
    for (const PolygonSoup& sheet :
         {tubeSheet(), asSoup(bentPanel(20)), weldedSoup(shirtSample())}) {
        const int count = sheet.faceCount();
        const PolygonSoup soup = withDivided(thickened(sheet), count, 2 * count);
        const FileSurface surface = surfaceOf(soup, 1);
        const auto shell = findShell(surface, Progress());
        ASSERT_TRUE(shell);
        EXPECT_EQ(sheetOf(soup, surface, *shell, ShellSurface::Outer).corners, sheet.corners);
        EXPECT_EQ(sheetOf(soup, surface, *shell, ShellSurface::Inner).faceCount(), 4 * count);
    }
}

/// A tube of cloth 3 mm thick with rims that are rounded off; its outline, once around.
std::vector<Eigen::Vector2d> roundedOff(int rimPoints) {
    constexpr double kRadius = 100, kHeight = 400, kHalf = 1.5;
    std::vector<Eigen::Vector2d> outline;
    const auto addRim = [&](double height, double sign) {
        for (int i = 1; i <= rimPoints; ++i) {
            const double turn = std::numbers::pi * i / (rimPoints + 1);
            outline.emplace_back(kRadius - kHalf + sign * kHalf * std::cos(turn),
                                 height + sign * kHalf * std::sin(turn));
        }
    };
    for (int i = 0; i <= 40; ++i) {
        outline.emplace_back(kRadius, kHeight * i / 40);
    }
    addRim(kHeight, 1);
    for (int i = 0; i <= 31; ++i) {
        outline.emplace_back(kRadius - 2 * kHalf, kHeight * (31 - i) / 31);
    }
    addRim(0, -1);
    outline.push_back(outline.front());
    return outline;
}

TEST(FindShell, StandsRimsThatAreRoundedOff) {
    for (const int rimPoints : {0, 1, 2, 3, 6}) {
        const PolygonSoup soup = revolved(roundedOff(rimPoints), 60);
        const FileSurface surface = surfaceOf(soup, 1);
        const auto shell = findShell(surface, Progress());
        ASSERT_TRUE(shell) << rimPoints;
        for (std::size_t t = 0; t < shell->side.size(); ++t) {
            const int row = surface.face[t] / 60;
            if (row < 40) {
                ASSERT_EQ(shell->side[t], ShellSide::Outer) << rimPoints << ", row " << row;
            } else if (row > 40 + rimPoints && row < 72 + rimPoints) {
                ASSERT_EQ(shell->side[t], ShellSide::Inner) << rimPoints << ", row " << row;
            }
        }
    }
}

TEST(FindShell, StandsRimsOfSeveralRows) {
    const int count = 2 * 48 * 20;
    PolygonSoup soup = asSoup(surfaceOf(thickened(tubeSheet()), 1).mesh);
    for (int i = 0; i < 2; ++i) {
        soup = withDivided(soup, 0, soup.faceCount());
    }
    const auto shell = shellOf(soup);
    ASSERT_TRUE(shell);
    for (std::size_t t = 0; t < shell->side.size(); ++t) {
        const int before = static_cast<int>(t) / 16;  // of the triangles that were divided
        ASSERT_EQ(shell->side[t], before < count       ? ShellSide::Outer
                                  : before < 2 * count ? ShellSide::Inner
                                                       : ShellSide::Rim);
    }
}

TEST(FindShell, DoesNotMindTheOrderOfTheFile) {
    const MeshArrays mesh = surfaceOf(thickened(tubeSheet()), 1).mesh;
    const Renumbered other = renumber(mesh, 7);
    const auto shell = shellOf(asSoup(mesh)), same = shellOf(asSoup(other.mesh));
    ASSERT_TRUE(shell && same);
    for (const ShellSide side : {ShellSide::Outer, ShellSide::Inner, ShellSide::Rim}) {
        EXPECT_EQ(std::count(shell->side.begin(), shell->side.end(), side),
                  std::count(same->side.begin(), same->side.end(), side));
    }
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
        const int partner = shell->partner[static_cast<std::size_t>(v)];
        ASSERT_EQ(same->partner[other.newIndex[v]], other.newIndex[partner]);
    }
}

TEST(FindShell, BearsFacesThatAreMissing) {
    const PolygonSoup sheet = tubeSheet();
    const PolygonSoup whole = thickened(sheet);
    const int count = sheet.faceCount();
    // One of the outer surface, and elsewhere one of the inner.
    const PolygonSoup soup = withoutFaces(whole, {400, count + 900});
    const FileSurface surface = surfaceOf(soup, 1);
    const auto shell = findShell(surface, Progress());
    ASSERT_TRUE(shell);
    EXPECT_EQ(sheetOf(soup, surface, *shell, ShellSurface::Outer).corners,
              withoutFaces(sheet, {400}).corners);
    EXPECT_EQ(sheetOf(soup, surface, *shell, ShellSurface::Inner).faceCount(), count - 1);
}

/// Both in one file; neither has a map or names.
PolygonSoup together(PolygonSoup soup, const PolygonSoup& other) {
    const int vertices = static_cast<int>(soup.positions.size());
    soup.positions.insert(soup.positions.end(), other.positions.begin(), other.positions.end());
    for (int face = 0; face < other.faceCount(); ++face) {
        for (int corner = other.faceStart[face]; corner < other.faceStart[face + 1]; ++corner) {
            soup.corners.push_back(other.corners[corner] + vertices);
        }
        soup.faceStart.push_back(static_cast<int>(soup.corners.size()));
    }
    return soup;
}

PolygonSoup wide(PolygonSoup soup, double times) {
    for (Eigen::Vector3d& position : soup.positions) {
        position = position.cwiseProduct(Eigen::Vector3d(times, 1, times));
    }
    return soup;
}

TEST(FindShell, TakesALiningThatIsThickForAnotherShell) {
    const PolygonSoup sheet = wide(tubeSheet(), 2), lining = wide(tubeSheet(), 1.9);
    const PolygonSoup soup = together(thickened(sheet), thickened(lining));
    const FileSurface surface = surfaceOf(soup, 1);
    const auto shell = findShell(surface, Progress());
    ASSERT_TRUE(shell);
    const PolygonSoup outer = sheetOf(soup, surface, *shell, ShellSurface::Outer);
    ASSERT_EQ(outer.faceCount(), 2 * sheet.faceCount());
    for (std::size_t corner = 0; corner < lining.corners.size(); ++corner) {
        ASSERT_EQ(outer.positions[outer.corners[sheet.corners.size() + corner]],
                  lining.positions[lining.corners[corner]]);
    }
}

TEST(FindShell, KeepsALiningThatIsASheet) {
    const PolygonSoup sheet = wide(tubeSheet(), 2), lining = wide(tubeSheet(), 1.9);
    for (const PolygonSoup& inside : {lining, turnedFrom(lining, 0)}) {
        const PolygonSoup soup = together(thickened(sheet), inside);
        const auto shell = shellOf(soup);
        ASSERT_TRUE(shell);
        EXPECT_EQ(std::count(shell->side.begin(), shell->side.end(), ShellSide::Single),
                  lining.faceCount());
        EXPECT_EQ(shell->side.back(), ShellSide::Single);
    }
}

TEST(FindShell, LeavesButtonsWhole) {
    const PolygonSoup button =
        thickened(asSoup(planeGrid(4, 4, 3)), {.thickness = [](const auto&) { return 3.0; }});
    const auto shell = shellOf(together(thickened(tubeSheet()), button));
    ASSERT_TRUE(shell);
    EXPECT_EQ(std::count(shell->side.begin(), shell->side.end(), ShellSide::Single),
              std::ssize(surfaceOf(button, 1).face));
    EXPECT_EQ(shell->partner.back(), -1);
}

TEST(FindShell, KeepsASheetThatLiesBesideIt) {
    PolygonSoup pocket = asSoup(planeGrid(10, 10, 20));
    for (Eigen::Vector3d& position : pocket.positions) {
        position.z() += 300;
    }
    const PolygonSoup soup = together(thickened(tubeSheet()), pocket);
    const FileSurface surface = surfaceOf(soup, 1);
    const auto shell = findShell(surface, Progress());
    ASSERT_TRUE(shell);
    EXPECT_EQ(std::count(shell->side.begin(), shell->side.end(), ShellSide::Single),
              pocket.faceCount());
    EXPECT_EQ(shell->side[surface.face.size() - 1], ShellSide::Single);
    EXPECT_EQ(sheetOf(soup, surface, *shell, ShellSurface::Inner).faceCount(),
              tubeSheet().faceCount() + pocket.faceCount());
}

}  // namespace
}  // namespace toile
