// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/mesh/edge_table.h"
#include "core/prepare/shell.h"
#include "tests/core/prepare/thick_shapes.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

using namespace test;

bool isShell(const PolygonSoup& soup, double millimetres) {
    return findShell(surfaceOf(soup, millimetres), Progress()).has_value();
}

MeshArrays scaled(MeshArrays mesh, double x, double y, double z) {
    mesh.V = mesh.V * Eigen::Vector3d(x, y, z).asDiagonal();
    return mesh;
}

MeshArrays ball(double radius) {
    return sphericalCap(40, radius, 3.0);
}

TEST(NoShell, OneSurfaceIsNone) {
    const std::vector<std::pair<const char*, MeshArrays>> shapes{
        {"plane", planeGrid(20, 20, 10)},
        {"panel", bentPanel(20)},
        {"tube", tube(48, 20)},
        {"cord", scaled(tube(16, 400), 0.06, 1, 0.06)},
        {"flattened tube", scaled(tube(48, 20), 1, 1, 0.05)},
        {"saddle", saddle(20, 300, 0.01)},
        {"cube", scaled(cubeOpenedAlongH(), 100, 100, 100)},
        {"octahedron", scaled(octahedron(), 100, 100, 100)},
        {"ball", ball(100)},
        {"cushion", scaled(ball(100), 3, 3, 0.2)},
        {"flat cushion", scaled(ball(100), 3, 0.05, 3)},
        {"torus", piercedTorus(60, 20)},
        {"moebius strip", moebiusStrip(60)},
        {"cone", coneSector(20, 20, 20, 300, 3, 0.5)},
    };
    for (const auto& [name, mesh] : shapes) {
        for (const double millimetres : {0.1, 1.0, 10.0}) {
            EXPECT_FALSE(isShell(asSoup(mesh), millimetres)) << name << " x " << millimetres;
        }
    }
}

/// A tube as it lies on a table: two layers a little apart, round or sharp where it is folded.
PolygonSoup foldedFlat(double width, double gap, int foldPoints) {
    MeshArrays mesh = tube(80 + 2 * foldPoints, 40);
    const int around = 80 + 2 * foldPoints, half = around / 2;
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
        const int k = static_cast<int>(v) % around, onHalf = k % half;
        const double sign = k < half ? 1 : -1;
        const double turn = std::numbers::pi * (onHalf - 39.5) / (foldPoints + 1);
        const bool isFlat = onHalf < 40;
        mesh.V(v, 0) =
            sign * (isFlat ? width * (onHalf / 39.0 - 0.5) : width / 2 + gap / 2 * std::sin(turn));
        mesh.V(v, 2) = sign * (isFlat ? gap / 2 : gap / 2 * std::cos(turn));
    }
    return asSoup(mesh);
}

TEST(NoShell, ATubeThatLiesFlatIsNone) {
    for (const int foldPoints : {0, 1, 2, 7}) {
        for (const double width : {100.0, 500.0}) {
            EXPECT_FALSE(isShell(foldedFlat(width, 4, foldPoints), 1))
                << foldPoints << ", " << width;
        }
    }
}

TEST(NoShell, ALiningAtAWanderingDistanceIsNone) {
    const auto wandering = [](const Eigen::Vector3d& position) {
        return 8 + 6 * std::sin(position.y() / 40) * std::cos(position.x() / 30);
    };
    const PolygonSoup sheet = asSoup(scaled(tube(64, 30), 4, 1, 4));
    EXPECT_FALSE(isShell(thickened(sheet, {.thickness = wandering, .rims = false}), 1));
    EXPECT_TRUE(isShell(thickened(sheet, {.rims = false}), 1));
}

TEST(NoShell, CancelledNothingIsFound) {
    Progress progress;
    progress.cancel();
    EXPECT_FALSE(findShell(surfaceOf(thickened(asSoup(tube(48, 20))), 1), progress));
}

TEST(NoShell, OurOwnSamplesAreNone) {
    for (const char* name : {"bodice", "cap", "skirt", "trousers", "tshirt"}) {
        Progress progress;
        const auto soup =
            readSoup(sourceFile(std::string("resources/samples/") + name + ".obj"), progress);
        ASSERT_TRUE(soup);
        EXPECT_FALSE(isShell(*soup, 1)) << name;
    }
}

class SharedFolder : public testing::TestWithParam<const char*> {};

TEST_P(SharedFolder, HasNoShell) {
    const std::filesystem::path folder = sharedFile(GetParam());
    TOILE_NEEDS_SHARED(folder);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        Progress progress;
        const auto soup = readSoup(entry.path(), progress);
        for (const double millimetres : {1.0, 10.0, 1000.0}) {
            EXPECT_FALSE(soup && isShell(*soup, millimetres))
                << entry.path() << " x " << millimetres;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, SharedFolder, testing::Values("garments", "disks", "nasty", "scans"),
                         [](const auto& given) { return std::string(given.param); });

/// Perimeters of the openings, ascending.
std::vector<double> openings(const MeshArrays& mesh) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    std::vector<double> perimeters;
    for (const RimLoop& loop : rimsOf(mesh, table)) {
        perimeters.push_back(loop.perimeter);
    }
    std::sort(perimeters.begin(), perimeters.end());
    return perimeters;
}

double areaOf(const MeshArrays& mesh) {
    double area = 0;
    for (Eigen::Index t = 0; t < mesh.F.rows(); ++t) {
        area += doubleAreaNormal(mesh, t).norm() / 2;
    }
    return area;
}

class SharedThick : public testing::TestWithParam<const char*> {};

/// A file that is a garment with a thickness gives the sheet that the garment is.
TEST_P(SharedThick, GivesTheSheet) {
    const auto path = sharedFile(std::string("thick/") + GetParam() + "_thick.obj");
    TOILE_NEEDS_SHARED(path);
    Progress progress;
    const auto thick = readSoup(path, progress);
    const auto thin =
        readSoup(sharedFile(std::string("garments/") + GetParam() + ".obj"), progress);
    ASSERT_TRUE(thick && thin);
    const FileSurface surface = surfaceOf(*thick, 10);
    const auto shell = findShell(surface, progress);
    ASSERT_TRUE(shell);
    const MeshArrays sheet =
        surfaceOf(sheetOf(*thick, surface, *shell, ShellSurface::Outer), 10).mesh;
    const MeshArrays expected = surfaceOf(*thin, 10).mesh;
    EXPECT_NEAR(areaOf(sheet), areaOf(expected), 0.001 * areaOf(expected));
    const auto components = faceComponents(sheet.F, static_cast<int>(sheet.V.rows()));
    EXPECT_EQ(*std::max_element(components.begin(), components.end()), 0);
    const std::vector<double> got = openings(sheet), wanted = openings(expected);
    ASSERT_EQ(got.size(), wanted.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
        EXPECT_NEAR(got[i], wanted[i], 0.005 * wanted[i]);
    }
}

INSTANTIATE_TEST_SUITE_P(All, SharedThick, testing::Values("tee_sim", "dress"),
                         [](const auto& given) { return std::string(given.param); });

}  // namespace
}  // namespace toile
