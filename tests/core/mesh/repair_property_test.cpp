// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "tests/core/mesh/repair_support.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

/// Damages a mesh in the ways that files do, by a fixed seed. Positions that coincide are always
/// joined by edges, so that faces are duplicates exactly where they have the same three positions.
class Vandal {
public:
    Vandal(MeshArrays mesh, unsigned seed) : mesh_(std::move(mesh)), random_(seed) {}

    MeshArrays damage(int times) {
        for (int i = 0; i < times; ++i) {
            damageOnce(below(8));
        }
        return mesh_;
    }

private:
    void damageOnce(int way) {
        const int f = below(static_cast<int>(mesh_.F.rows()));
        const Eigen::RowVector3i face = mesh_.F.row(f);
        const int k = below(3);
        switch (way) {
            case 0:
                std::swap(mesh_.F(f, 1), mesh_.F(f, 2));
                break;
            case 1:  // doubled, turned or not
                addFace(face[k], face[(k + 1) % 3], face[(k + 2) % 3]);
                break;
            case 2:
                addFace(face[(k + 2) % 3], face[(k + 1) % 3], face[k]);
                break;
            case 3:
                addFace(face[k], face[k], face[(k + 1) % 3]);
                break;
            case 4:
                addFlat(f, k);
                break;
            case 5:  // a fin on an edge
                addFace(face[k], face[(k + 1) % 3], addVertex(somewhere()));
                break;
            case 6: {  // a face between vertices that have nothing to do with each other
                const int v = below(static_cast<int>(mesh_.V.rows()));
                addFace(face[k], v, face[(k + 1) % 3]);
                break;
            }
            default: {  // a flag on a vertex
                const int v = addVertex(somewhere());
                addFace(face[k], v, addVertex(somewhere()));
                break;
            }
        }
    }

    /// Divides a face at a point of one side, at an end or between, and fills the slit that opens
    /// towards the neighbour with a triangle of no area.
    void addFlat(int f, int k) {
        const int a = mesh_.F(f, k);
        const int b = mesh_.F(f, (k + 1) % 3);
        const int c = mesh_.F(f, (k + 2) % 3);
        const double t = 0.25 * below(5);
        const int m = addVertex((1 - t) * mesh_.V.row(a) + t * mesh_.V.row(b));
        mesh_.F.row(f) << a, m, c;
        addFace(m, b, c);
        addFace(a, b, m);
    }

    Eigen::RowVector3d somewhere() {
        return {below(100) + 0.25, below(100) + 0.5, 7.0 + below(100)};
    }

    int addVertex(const Eigen::RowVector3d& p) {
        mesh_.V.conservativeResize(mesh_.V.rows() + 1, 3);
        mesh_.V.bottomRows(1) = p;
        return static_cast<int>(mesh_.V.rows()) - 1;
    }

    void addFace(int a, int b, int c) {
        mesh_.F.conservativeResize(mesh_.F.rows() + 1, 3);
        mesh_.F.bottomRows(1) << a, b, c;
    }

    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

    MeshArrays mesh_;
    std::mt19937 random_;
};

/// The area with every set of three positions counted once.
double areaWithoutDuplicates(const MeshArrays& mesh) {
    using Position = std::array<double, 3>;
    std::set<std::array<Position, 3>> seen;
    double area = 0;
    for (int f = 0; f < mesh.F.rows(); ++f) {
        std::array<Position, 3> corners;
        for (int k = 0; k < 3; ++k) {
            const auto p = mesh.V.row(mesh.F(f, k));
            corners[k] = {p[0], p[1], p[2]};
        }
        std::sort(corners.begin(), corners.end());
        if (seen.insert(corners).second) {
            area += test::areaOf({mesh.V, mesh.F.row(f)});
        }
    }
    return area;
}

MeshArrays shapeFor(unsigned seed) {
    switch (seed % 4) {
        case 0:
            return test::planeGrid(4, 3, 10);
        case 1:
            return test::sphericalCap(4, 40, 1.2);
        case 2:
            return test::octahedron();
        default:
            return test::tube(7, 3);
    }
}

TEST(RepairProperty, WhateverTheDamageTheResultIsAnOrientedManifoldOfTheSameArea) {
    for (unsigned seed = 0; seed < 400; ++seed) {
        SCOPED_TRACE(seed);
        const MeshArrays damaged =
            Vandal(shapeFor(seed), seed).damage(1 + static_cast<int>(seed % 23));
        const RepairResult result = repair(test::asPart(damaged), "damaged");
        test::expectOrientedManifold(result.part.mesh);
        test::expectSources(result.part, damaged);
        const double area = areaWithoutDuplicates(damaged);
        EXPECT_NEAR(test::areaOf(result.part.mesh), area, 1e-9 * area);
        EXPECT_FALSE(result.repairs.empty());
        if (testing::Test::HasFailure()) {
            break;
        }
    }
}

TEST(RepairProperty, ARepairedMeshNeedsNoRepair) {
    for (unsigned seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        const MeshArrays damaged = Vandal(shapeFor(seed), seed).damage(12);
        const RepairResult once = repair(test::asPart(damaged), "damaged");
        const RepairResult twice = repair(once.part, "damaged");
        EXPECT_EQ(test::kindsOf(twice.repairs), "");
        EXPECT_EQ(twice.part.mesh.F, once.part.mesh.F);
        EXPECT_EQ(twice.part.mesh.V, once.part.mesh.V);
    }
}

TEST(RepairProperty, ScaleDoesNotMatter) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        const MeshArrays damaged = Vandal(shapeFor(seed), seed).damage(12);
        const RepairResult plain = repair(test::asPart(damaged), "damaged");
        for (const int exponent : {-24, 20}) {  // powers of two: the same digits
            MeshArrays scaled = damaged;
            scaled.V *= std::ldexp(1.0, exponent);
            const RepairResult result = repair(test::asPart(scaled), "damaged");
            EXPECT_EQ(result.part.mesh.F, plain.part.mesh.F);
            EXPECT_EQ(test::kindsOf(result.repairs), test::kindsOf(plain.repairs));
        }
    }
}

TEST(RepairProperty, FarFromTheOriginTheResultIsStillAManifold) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        MeshArrays damaged = Vandal(shapeFor(seed), seed).damage(12);
        damaged.V.rowwise() += Eigen::RowVector3d(1e6, -2e6, 3e6);
        const RepairResult result = repair(test::asPart(damaged), "far");
        test::expectOrientedManifold(result.part.mesh);
        test::expectSources(result.part, damaged);
    }
}

}  // namespace
}  // namespace toile
