// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/remesh.h"

#include <gtest/gtest.h>

#include "core/cut/surface_point.h"
#include "tests/core/prepare/scan_shapes.h"

namespace toile {
namespace {

using test::edgesOf;

int eulerCharacteristic(const MeshArrays& mesh) {
    return static_cast<int>(mesh.V.rows() - edgesOf(mesh).edges.rows() + mesh.F.rows());
}

/// The share of edges within the bounds of [BK04] section 4.
double shareOfEvenEdges(const MeshArrays& mesh, double length) {
    const Edges edges = edgesOf(mesh).edges;
    int even = 0;
    for (int e = 0; e < edges.rows(); ++e) {
        const double ratio = (mesh.V.row(edges(e, 0)) - mesh.V.row(edges(e, 1))).norm() / length;
        even += ratio > 4.0 / 5 && ratio < 4.0 / 3 ? 1 : 0;
    }
    return static_cast<double>(even) / static_cast<double>(edges.rows());
}

/// Quality of triangles: 1 of an equilateral one, 0 of one without height.
struct Quality {
    double mean = 0;
    double least = 1;
};

Quality qualityOf(const MeshArrays& mesh) {
    Quality quality;
    for (int f = 0; f < mesh.F.rows(); ++f) {
        double squares = 0;
        for (int k = 0; k < 3; ++k) {
            squares +=
                (mesh.V.row(mesh.F(f, k)) - mesh.V.row(mesh.F(f, (k + 1) % 3))).squaredNorm();
        }
        const double one = 2 * std::sqrt(3) * doubleAreaNormal(mesh, f).norm() / squares;
        quality.mean += one / static_cast<double>(mesh.F.rows());
        quality.least = std::min(quality.least, one);
    }
    return quality;
}

/// How far the vertices of one lie from the other, at most.
double distance(const MeshArrays& from, const MeshArrays& to) {
    const NearestSurface surface(to);
    double most = 0;
    for (int v = 0; v < from.V.rows(); ++v) {
        const Eigen::Vector3d p = from.V.row(v);
        most = std::max(most, (positionOf(to, surface.find(p)) - p).norm());
    }
    return most;
}

/// Remeshes, and checks what holds of every surface.
MeshArrays remeshedSoundly(const MeshArrays& mesh, double length) {
    const auto fresh = remeshed(mesh, length, Progress());
    EXPECT_TRUE(fresh);
    if (!fresh) {
        return mesh;
    }
    EXPECT_TRUE(isValidSurface(*fresh, edgesOf(*fresh)));
    EXPECT_EQ(eulerCharacteristic(*fresh), eulerCharacteristic(mesh));
    const std::vector<double> before = test::perimeters(mesh), after = test::perimeters(*fresh);
    EXPECT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < before.size() && i < after.size(); ++i) {
        EXPECT_LE(after[i], before[i] * (1 + 1e-9));
        EXPECT_GE(after[i], before[i] * (1 - 0.003));
    }
    return *fresh;
}

TEST(Remesh, TrianglesAreEvenAndRimsAndAreaStay) {
    for (const double length : {6.0, 25.0}) {
        const MeshArrays mesh = test::withHole(test::skirt(), 0, 300, 45);
        const MeshArrays fresh = remeshedSoundly(mesh, length);
        EXPECT_NEAR(test::clothArea(fresh), test::clothArea(mesh), 0.005 * test::clothArea(mesh));
        // Of 10 mm half of 5 mm is made, whose squares with a diagonal are even enough to stay.
        EXPECT_GT(shareOfEvenEdges(fresh, length), length < 10 ? 0.95 : 0.87);
        EXPECT_GT(qualityOf(fresh).mean, length < 10 ? 0.86 : 0.94);
        EXPECT_GT(qualityOf(fresh).least, 0.3);
        const MeshArrays again = remeshedSoundly(mesh, length);
        EXPECT_EQ(again.V, fresh.V);
        EXPECT_EQ(again.F, fresh.F);
    }
}

TEST(Remesh, CornersOfAnOutlineStay) {
    const MeshArrays mesh = test::planeGrid(40, 40, 5);
    const MeshArrays fresh = remeshedSoundly(mesh, 12);
    EXPECT_NEAR(test::clothArea(fresh), 200 * 200, 1e-6);
    EXPECT_NEAR(test::perimeters(fresh).at(0), 800, 1e-6);
    EXPECT_LT(distance(mesh, fresh), 1e-9);
    EXPECT_LT(distance(fresh, mesh), 1e-9);
}

TEST(Remesh, ARimKeepsItsCornersAndItsLength) {
    // Zigzags of 60 mm stay, those of 1 mm need not.
    for (const double tooth : {60.0, 1.0}) {
        MeshArrays mesh = test::planeGrid(60, 30, 5);
        double low = mesh.V.col(1).minCoeff();
        std::vector<int> corners;
        for (int v = 0; v < mesh.V.rows(); ++v) {
            const double phase = std::remainder(mesh.V(v, 0) - mesh.V.col(0).minCoeff(), tooth);
            if (mesh.V(v, 1) == low) {
                mesh.V(v, 1) -= std::abs(phase) / 4;
            }
        }
        for (const RimLoop& rim : rimsOf(mesh, edgesOf(mesh))) {
            double length = 0;
            corners = findRimCorners(mesh.V, rim, 12);
            for (std::size_t i = 0; i < corners.size(); ++i) {
                length +=
                    (mesh.V.row(corners[i]) - mesh.V.row(corners[(i + 1) % corners.size()])).norm();
            }
            EXPECT_LE(length, rim.perimeter * (1 + 1e-12));
            EXPECT_GE(length, rim.perimeter * (1 - 0.003));
        }
        remeshedSoundly(mesh, 12);
    }
}

TEST(Remesh, KeepsTheTopology) {
    const MeshArrays octahedron = test::octahedron();
    EXPECT_EQ(eulerCharacteristic(remeshedSoundly(octahedron, 1e3)), 2);
    const double size = octahedron.V.maxCoeff();
    EXPECT_EQ(eulerCharacteristic(remeshedSoundly(octahedron, size / 10)), 2);
    const MeshArrays torus = test::piercedTorus(40, 20);
    const double edge = (torus.V.row(0) - torus.V.row(1)).norm();
    for (const double factor : {0.4, 1.0, 3.0}) {
        remeshedSoundly(torus, factor * edge);
    }
    remeshedSoundly(test::beside(test::saddle(20, 200, 0.3), torus, {500, 0, 0}), 20);
}

TEST(Remesh, ASphereStaysRound) {
    constexpr double kRadius = 100, kLength = 8;
    const MeshArrays mesh = test::sphericalCap(60, kRadius, 2.5);
    const MeshArrays fresh = remeshedSoundly(mesh, kLength);
    const double sagitta = kLength * kLength / (8 * kRadius);
    Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
    {  // from the rim's plane and the pole it follows; here from four vertices of the input
        Eigen::Matrix3d normals;
        Eigen::Vector3d right;
        for (int k = 0; k < 3; ++k) {
            const Eigen::RowVector3d a = mesh.V.row(0);
            const Eigen::RowVector3d b = mesh.V.row((k + 1) * (mesh.V.rows() - 1) / 3 - k);
            normals.row(k) = b - a;
            right[k] = (b.squaredNorm() - a.squaredNorm()) / 2;
        }
        centre = normals.fullPivLu().solve(right).transpose();
    }
    ASSERT_NEAR((mesh.V.row(mesh.V.rows() / 2) - centre).norm(), kRadius, 1e-6);
    for (int v = 0; v < fresh.V.rows(); ++v) {
        EXPECT_NEAR((fresh.V.row(v) - centre).norm(), kRadius, 2 * sagitta);
    }
    EXPECT_NEAR(test::clothArea(fresh), test::clothArea(mesh), 1e-3 * test::clothArea(mesh));
    EXPECT_GT(shareOfEvenEdges(fresh, kLength), 0.94);
}

TEST(Remesh, WhatIsEvenStaysSo) {
    const MeshArrays once = remeshedSoundly(test::skirt(), 12);
    const MeshArrays twice = remeshedSoundly(once, 12);
    const auto count = static_cast<double>(once.F.rows());
    EXPECT_NEAR(static_cast<double>(twice.F.rows()), count, 0.02 * count);
    EXPECT_GE(qualityOf(twice).mean, qualityOf(once).mean - 0.005);
    EXPECT_NEAR(test::clothArea(twice), test::clothArea(once), 1e-3 * test::clothArea(once));
    EXPECT_LT(distance(twice, once), 0.5);
}

TEST(Remesh, NeedlesBecomeEven) {
    for (const int around : {6, 300}) {  // triangles of 200 mm and more, 157 mm to 3 mm wide
        MeshArrays mesh = test::tube(around, 3);
        mesh.V.col(0) *= 3;
        mesh.V.col(1) *= 10;
        mesh.V.col(2) *= 3;
        const MeshArrays fresh = remeshedSoundly(mesh, 15);
        EXPECT_GT(shareOfEvenEdges(fresh, 15), 0.9);
        EXPECT_GT(qualityOf(fresh).mean, 0.93);
        EXPECT_NEAR(test::clothArea(fresh), test::clothArea(mesh), 0.01 * test::clothArea(mesh));
    }
}

TEST(Remesh, HugeAndTinyTrianglesBecomeEven) {
    MeshArrays mesh = test::planeGrid(40, 40, 5);
    const double left = mesh.V.col(0).minCoeff(), width = 200;
    for (int v = 0; v < mesh.V.rows(); ++v) {  // from 0.003 mm to 15 mm wide
        mesh.V(v, 0) = left + width * std::pow((mesh.V(v, 0) - left) / width, 3);
    }
    const MeshArrays fresh = remeshedSoundly(mesh, 8);
    EXPECT_NEAR(test::clothArea(fresh), 200 * 200, 1e-6);
    EXPECT_GT(shareOfEvenEdges(fresh, 8), 0.9);
    EXPECT_GT(qualityOf(fresh).least, 0.3);
}

TEST(Remesh, ThinClothKeepsItsSides) {
    MeshArrays mesh = test::skirt();  // pressed flat: two sheets 1.5 mm apart
    mesh.V.col(2) *= 0.005;
    const MeshArrays fresh = remeshedSoundly(mesh, 12);
    EXPECT_NEAR(test::clothArea(fresh), test::clothArea(mesh), 0.02 * test::clothArea(mesh));
    EXPECT_LT(distance(mesh, fresh), 1.5);
}

TEST(Remesh, RefusesWhatWouldTakeForEver) {
    EXPECT_FALSE(remeshed(test::skirt(), 0.05, Progress()));
    for (const int rim : {500, 5000}) {  // a disk, all of whose triangles meet in its middle
        MeshArrays fan{Points3(rim + 1, 3), Triangles(rim, 3)};
        fan.V.row(rim).setZero();
        for (int v = 0; v < rim; ++v) {
            const double angle = 2 * std::numbers::pi * v / rim;
            fan.V.row(v) << std::cos(angle), std::sin(angle), 0;
            fan.F.row(v) << v, (v + 1) % rim, rim;
        }
        if (rim == 500) {
            EXPECT_GT(qualityOf(remeshedSoundly(fan, 0.1)).mean, 0.9);
        } else {
            EXPECT_FALSE(remeshed(fan, 0.1, Progress()));
        }
    }
}

TEST(Remesh, ACancelIsHeard) {
    Progress progress;
    progress.cancel();
    EXPECT_FALSE(remeshed(test::skirt(), 10, progress));
    EXPECT_FALSE(remeshed(test::octahedron(), 10, progress));
}

}  // namespace
}  // namespace toile
