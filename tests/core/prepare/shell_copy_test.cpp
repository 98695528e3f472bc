// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <functional>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/prepare/shell.h"
#include "tests/core/prepare/thick_shapes.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using namespace test;

double waves(const Eigen::Vector3d& position) {
    return 1.5 * (1 + 0.2 * std::sin(position.y() / 60) * std::cos(position.x() / 80));
}

double collarAndBody(const Eigen::Vector3d& position) {
    return position.y() > 300 ? 3.0 : 1.0;
}

/// A skirt of quads whose hem is folded in, 4 mm from it.
PolygonSoup hemmed() {
    std::vector<Eigen::Vector2d> profile;
    for (int i = 0; i < 20; ++i) {
        profile.emplace_back(96, 60 - 3 * i);
    }
    for (const auto& [radius, height] : {std::pair(96.7, 1.5), {98.0, 0.7}, {99.3, 1.5}}) {
        profile.emplace_back(radius, height);
    }
    for (int i = 0; i < 40; ++i) {
        profile.emplace_back(100, 3 + 10 * i);
    }
    return revolved(profile, 60);
}

struct ThickCase {
    const char* name;
    std::function<PolygonSoup()> sheet;
    std::function<PolygonSoup(const PolygonSoup&)> thicken;
};

std::ostream& operator<<(std::ostream& out, const ThickCase& one) {
    return out << one.name;
}

class ThickCopy : public testing::TestWithParam<ThickCase> {};

/// The outer surface is the sheet that was thickened, face by face, names and map included.
TEST_P(ThickCopy, GivesTheSheetBack) {
    const PolygonSoup sheet = GetParam().sheet();
    const PolygonSoup soup = GetParam().thicken(sheet);
    const FileSurface surface = surfaceOf(soup, 1);
    const std::optional<Shell> shell = findShell(surface, Progress());
    ASSERT_TRUE(shell);
    EXPECT_GT(shell->pairedShare, 0.95);
    const int count = sheet.faceCount();
    for (std::size_t t = 0; t < shell->side.size(); ++t) {
        const int face = surface.face[t];
        const ShellSide expected = face < count       ? ShellSide::Outer
                                   : face < 2 * count ? ShellSide::Inner
                                                      : ShellSide::Rim;
        ASSERT_EQ(shell->side[t], expected) << "face " << face << " of " << count;
    }
    const PolygonSoup outer = sheetOf(soup, surface, *shell, ShellSurface::Outer);
    EXPECT_EQ(outer.faceCount(), count);
    EXPECT_EQ(outer.cornerUvs, sheet.cornerUvs);
    EXPECT_EQ(outer.faceObject, sheet.faceObject);
    for (std::size_t corner = 0; corner < sheet.corners.size(); ++corner) {
        ASSERT_EQ(outer.positions[outer.corners[corner]], sheet.positions[sheet.corners[corner]]);
    }
    // The inner one is seen from outside too: turned, it is the same sheet.
    const PolygonSoup inner = sheetOf(soup, surface, *shell, ShellSurface::Inner);
    ASSERT_EQ(inner.corners.size(), sheet.corners.size());
    EXPECT_EQ(inner.cornerUvs, sheet.cornerUvs);
    for (std::size_t corner = 0; corner < sheet.corners.size(); ++corner) {
        ASSERT_LT((inner.positions[inner.corners[corner]] - outer.positions[outer.corners[corner]])
                      .norm(),
                  3.7);
    }
    const LeftOut left = leftOut(surface, *shell, ShellSurface::Outer);
    EXPECT_EQ(std::ssize(left.other), count);
    EXPECT_EQ(std::ssize(left.rims), soup.faceCount() - 2 * count);
}

PolygonSoup plainly(const PolygonSoup& sheet) {
    return thickened(sheet);
}

PolygonSoup shirtSoup() {
    return withMap(shirtSample());
}

PolygonSoup weldedShirt() {
    return weldedSoup(withMap(shirtSample()));
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, ThickCopy,
    testing::Values(
        ThickCase{"tube", tubeSheet, plainly},
        ThickCase{"panel", [] { return asSoup(bentPanel(20)); }, plainly},
        ThickCase{"shirt_panel_by_panel", shirtSoup, plainly},
        ThickCase{"shirt_welded", weldedShirt, plainly},
        ThickCase{"without_rims", tubeSheet,
                  [](const auto& sheet) { return thickened(sheet, {.rims = false}); }},
        ThickCase{"thickness_varies", weldedShirt,
                  [](const auto& sheet) { return thickened(sheet, {.thickness = waves}); }},
        ThickCase{"two_thicknesses", tubeSheet,
                  [](const auto& sheet) { return thickened(sheet, {.thickness = collarAndBody}); }},
        ThickCase{"loose_triangles", tubeSheet,
                  [](const auto& sheet) { return looseSoup(thickened(sheet)); }},
        ThickCase{"hem_folded_in", hemmed, plainly},
        ThickCase{"hole_through_both",
                  [] {
                      return withoutFaces(tubeSheet(), {300, 301});
                  },
                  [](const auto& sheet) { return thickened(sheet, {.rims = false}); }}),
    [](const auto& given) { return given.param.name; });

}  // namespace
}  // namespace toile
