// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/scan.h"

#include <filesystem>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/mesh/disk_check.h"
#include "core/mesh/repair.h"
#include "core/prepare/file_surface.h"
#include "tests/core/prepare/scan_shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

constexpr ScanSteps kNothing{false, 0, 0, 0};

PreparedScan prepared(const PolygonSoup& soup, const ScanSteps& steps) {
    Progress progress;
    return *prepareScan(soup, 10, steps, progress);
}

/// A skirt as a scanner leaves it: noise, two holes, fragments that float about, one that hangs on
/// by a vertex.
MeshArrays scannedSkirt() {
    MeshArrays mesh = test::withHole(test::skirt(), 0, 300, 30);
    mesh = test::withHole(mesh, 60, 120, 15);
    mesh = test::withNoise(mesh, 0.6);
    mesh = test::beside(mesh, test::planeGrid(2, 2, 6), {200, 50, 30});
    mesh = test::beside(mesh, test::planeGrid(1, 2, 3), {-3, 44, 150});
    const auto hanging = static_cast<int>(mesh.V.rows()) - 1;
    for (int& v : cornersOf(mesh.F)) {
        v = v == hanging ? 94 * 5 : v;
    }
    return mesh;
}

TEST(Scan, BecomesOneSheetWithItsOpenings) {
    const MeshArrays scan = scannedSkirt();
    const PreparedScan result = prepared(test::inCentimetres(scan), {});
    EXPECT_EQ(result.effect.fragments, 2);
    EXPECT_EQ(result.debris.size(), 8U + 4U);
    EXPECT_EQ(result.effect.holes, 2);
    EXPECT_EQ(result.effect.openings, 2);
    EXPECT_LE(result.effect.largestMove, ScanSteps().smoothing * (1 + 1e-9));
    const MeshArrays sheet = surfaceOf(result.soup, 10).mesh;
    EXPECT_TRUE(isValidSurface(sheet, test::edgesOf(sheet)));
    EXPECT_EQ(result.effect.triangles, sheet.F.rows());
    EXPECT_LT(test::offSkirt(sheet.V).mean, 0.2);  // 0.3 before
    for (const double perimeter : test::perimeters(sheet)) {
        EXPECT_NEAR(perimeter, test::perimeters(test::skirt())[0], 0.01 * perimeter);
    }
    EXPECT_NEAR(test::clothArea(sheet), test::clothArea(test::skirt()),
                0.01 * test::clothArea(sheet));
}

TEST(Scan, IsRemeshedToTheWantedLength) {
    ScanSteps steps;
    steps.edgeLength = 25;
    const PreparedScan result = prepared(test::inCentimetres(scannedSkirt()), steps);
    EXPECT_TRUE(result.effect.isRemeshed);
    EXPECT_EQ(result.effect.openings, 2);
    const MeshArrays sheet = surfaceOf(result.soup, 10).mesh;
    EXPECT_TRUE(isValidSurface(sheet, test::edgesOf(sheet)));
    const double triangle = std::sqrt(3) / 4 * 25 * 25;
    EXPECT_NEAR(test::clothArea(sheet) / static_cast<double>(sheet.F.rows()), triangle,
                0.3 * triangle);
}

TEST(Scan, WithoutStepsIsTheFile) {
    const PolygonSoup soup = test::inCentimetres(scannedSkirt());
    const PreparedScan result = prepared(soup, kNothing);
    EXPECT_EQ(result.soup.corners, soup.corners);
    EXPECT_EQ(result.soup.positions, soup.positions);
    EXPECT_TRUE(result.debris.empty());
}

TEST(Scan, WithoutDebrisKeepsPolygonsNamesAndMap) {
    PolygonSoup soup = test::inCentimetres(test::skirt());
    soup.corners.resize(soup.corners.size() - 6);  // the last two triangles become a polygon
    soup.faceStart.resize(soup.faceStart.size() - 2);
    const int last = 59 * 94 + 93, first = 59 * 94;
    for (const int v : {last, first, first + 94, last + 94}) {
        soup.corners.push_back(v);
    }
    soup.faceStart.push_back(static_cast<int>(soup.corners.size()));
    for (const double x : {50.0, 50.5, 50.0}) {  // and a fragment
        soup.corners.push_back(static_cast<int>(soup.positions.size()));
        soup.positions.emplace_back(x, x * x / 50, 3);
    }
    soup.faceStart.push_back(static_cast<int>(soup.corners.size()));
    soup.groups = {"skirt", "floor"};
    soup.faceGroup.assign(static_cast<std::size_t>(soup.faceCount()), 0);
    soup.faceGroup.back() = 1;
    soup.uvs.assign(3, {0.5, 0.5});
    soup.cornerUvs.assign(soup.corners.size(), 2);
    ScanSteps steps = kNothing;
    steps.dropDebris = true;
    const PreparedScan result = prepared(soup, steps);
    EXPECT_EQ(result.debris, std::vector<int>{soup.faceCount() - 1});
    EXPECT_EQ(result.soup.cornerCount(result.soup.faceCount() - 1), 4);
    EXPECT_EQ(result.soup.faceGroup,
              std::vector<int>(static_cast<std::size_t>(soup.faceCount() - 1), 0));
    EXPECT_EQ(result.soup.cornerUvs.size(), result.soup.corners.size());
    // Smoothing moves positions alone; the last polygon is two triangles then.
    steps.smoothing = 1;
    const PreparedScan smooth = prepared(soup, steps);
    EXPECT_EQ(smooth.soup.faceCount(), result.soup.faceCount() + 1);
    EXPECT_EQ(smooth.soup.cornerUvs, std::vector<int>(smooth.soup.corners.size(), 2));
    EXPECT_EQ(smooth.soup.groups, soup.groups);
}

TEST(Scan, PatchesHaveTheNamesAroundThem) {
    PolygonSoup soup = test::inCentimetres(test::withHole(test::skirt(), 0, 300, 30));
    soup.materials = {"linen"};
    soup.faceMaterial.assign(static_cast<std::size_t>(soup.faceCount()), 0);
    const PreparedScan result = prepared(soup, {});
    EXPECT_GT(result.soup.faceCount(), soup.faceCount());
    EXPECT_EQ(result.soup.faceMaterial,
              std::vector<int>(static_cast<std::size_t>(result.soup.faceCount()), 0));
}

TEST(Scan, SameInputSameOutput) {
    ScanSteps steps;
    steps.edgeLength = 12;
    const PolygonSoup soup = test::inCentimetres(scannedSkirt());
    const PreparedScan a = prepared(soup, steps), b = prepared(soup, steps);
    EXPECT_EQ(a.soup.positions, b.soup.positions);
    EXPECT_EQ(a.soup.corners, b.soup.corners);
}

TEST(Scan, ACancelIsAnError) {
    Progress progress;
    progress.cancel();
    const auto result = prepareScan(test::inCentimetres(scannedSkirt()), 10, {}, progress);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
}

TEST(Scan, NothingGivesNothing) {
    ScanSteps steps;
    steps.edgeLength = 5;
    EXPECT_EQ(prepared({}, steps).soup.faceCount(), 0);
    PolygonSoup soup;
    soup.positions.assign(3, Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()));
    soup.corners = {0, 1, 2};
    soup.faceStart = {0, 3};
    EXPECT_EQ(prepared(soup, steps).soup.faceCount(), 0);
}

/// Whatever came, what comes is a file's soup: of numbers, and of names that there are.
void expectSound(const PreparedScan& result) {
    const PolygonSoup& soup = result.soup;
    ASSERT_EQ(soup.faceStart.size(), static_cast<std::size_t>(soup.faceCount()) + 1);
    ASSERT_EQ(soup.faceStart.back(), static_cast<int>(soup.corners.size()));
    for (const int v : soup.corners) {
        ASSERT_TRUE(v >= 0 && v < static_cast<int>(soup.positions.size()));
        EXPECT_TRUE(soup.positions[static_cast<std::size_t>(v)].allFinite());
    }
    for (const auto* perFace : {&soup.faceObject, &soup.faceGroup, &soup.faceMaterial}) {
        EXPECT_TRUE(perFace->empty() ||
                    perFace->size() == static_cast<std::size_t>(soup.faceCount()));
    }
    EXPECT_TRUE(soup.cornerUvs.empty() || soup.cornerUvs.size() == soup.corners.size());
    const MeshArrays sheet = surfaceOf(soup, 10).mesh;
    EXPECT_EQ(isValidSurface(sheet, test::edgesOf(sheet)), result.effect.isSurface);
}

TEST(Scan, OfAnyFileIsSound) {
    const auto folder = test::sharedFile("nasty");
    TOILE_NEEDS_SHARED(folder);
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        SCOPED_TRACE(entry.path().filename());
        Progress progress;
        const Result<PolygonSoup> soup = readSoup(entry.path(), progress);
        if (!soup) {
            continue;
        }
        Eigen::AlignedBox3d box;
        for (const Eigen::Vector3d& position : soup->positions) {
            if (position.allFinite()) {
                box.extend(position);
            }
        }
        const double size = 10 * box.diagonal().norm();
        const PreparedScan result = prepared(*soup, {true, size, size / 1000, size / 30});
        expectSound(result);
        EXPECT_EQ(result.effect.isSurface, entry.path().filename() != "moebius.obj");
    }
}

TEST(Scan, OfTrianglesAtRandomIsSound) {
    std::mt19937 random(23);
    for (int round = 0; round < 40; ++round) {
        PolygonSoup soup;
        for (int v = 0; v < 12; ++v) {  // many in one place, many in one line
            soup.positions.emplace_back(random() % 3, random() % 3, random() % 2);
        }
        for (int f = 0; f < 30; ++f) {
            for (int k = 0; k < 3; ++k) {
                soup.corners.push_back(static_cast<int>(random() % 12));
            }
            soup.faceStart.push_back(3 * (f + 1));
        }
        for (const double edge : {0.0, 4.0}) {
            expectSound(prepared(soup, {true, 100, 2, edge}));
        }
    }
}

TEST(Scan, OfTheDressIsOneSheetWithNeckAndHem) {
    const auto path = test::sharedFile("scans/dress_scan.obj");
    TOILE_NEEDS_SHARED(path);
    Progress progress;
    const Result<PolygonSoup> soup = readSoup(path, progress);
    ASSERT_TRUE(soup);
    ScanSteps steps;
    steps.edgeLength = 10;
    const PreparedScan result = prepared(*soup, steps);
    const MeshArrays sheet = surfaceOf(result.soup, 10).mesh;
    EXPECT_TRUE(isValidSurface(sheet, test::edgesOf(sheet)));
    EXPECT_EQ(
        connectedParts({sheet, std::vector<int>(sheet.V.rows()), std::vector<int>(sheet.F.rows())})
            .size(),
        1U);
    // The straps are but fragments in the scan, so neck and arms are one opening.
    const std::vector<double> openings = test::perimeters(sheet);
    ASSERT_EQ(openings.size(), 2U);
    EXPECT_GT(openings[0], 1000);
}

TEST(Scan, OpeningsOfTheSewnDressStayOpen) {
    const auto path = test::sharedFile("garments/dress.obj");
    TOILE_NEEDS_SHARED(path);
    Progress progress;
    const Result<PolygonSoup> soup = readSoup(path, progress);
    ASSERT_TRUE(soup);
    const PreparedScan result = prepared(*soup, {});
    EXPECT_EQ(result.effect.holes, 0);
    EXPECT_EQ(result.effect.fragments, 0);
    EXPECT_EQ(result.effect.openings, 4);  // neck, arms, hem
}

}  // namespace
}  // namespace toile
