// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/smooth.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/mesh/disk_check.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

/// Two planes that meet at a right angle in the line x = 200, z = 0: a fold.
MeshArrays fold() {
    MeshArrays mesh = test::planeGrid(40, 40, 10);
    for (int v = 0; v < mesh.V.rows(); ++v) {
        const double beyond = mesh.V(v, 0) - 200;
        if (beyond > 0) {
            mesh.V(v, 0) = 200;
            mesh.V(v, 2) = beyond;
        }
    }
    return mesh;
}

double distanceToFold(const Eigen::RowVector3d& point) {
    return std::min(std::hypot(point.z(), std::max(point.x() - 200, 0.0)),
                    std::hypot(point.x() - 200, std::min(point.z(), 0.0)));
}

MeshArrays noisy(MeshArrays mesh, double most) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(-most, most);
    for (Eigen::Index i = 0; i < mesh.V.size(); ++i) {
        mesh.V.data()[i] += part(random);
    }
    return mesh;
}

double noiseOf(const Points3& V) {
    double sum = 0;
    for (int v = 0; v < V.rows(); ++v) {
        sum += distanceToFold(V.row(v));
    }
    return sum / static_cast<double>(V.rows());
}

TEST(Smooth, TakesNoiseFromAFoldAndKeepsTheFold) {
    const MeshArrays mesh = noisy(fold(), 1);
    const Points3 V = smoothed(mesh, 2, Progress());
    EXPECT_LT(noiseOf(V), 0.4 * noiseOf(mesh.V));
    const MeshArrays known = fold();
    double offCrease = 0;  // of what was in the crease; rounding it off takes it inwards
    int creased = 0;
    for (int v = 0; v < V.rows(); ++v) {
        if (known.V(v, 0) == 200 && known.V(v, 2) == 0) {
            offCrease += std::hypot(V(v, 0) - 200, V(v, 2));
            ++creased;
        }
    }
    EXPECT_LT(offCrease / creased, 1.0);
}

TEST(Smooth, LeavesAFoldWithoutNoiseAsItIs) {
    const MeshArrays mesh = fold();
    const Points3 V = smoothed(mesh, 2, Progress());
    EXPECT_LT((V - mesh.V).rowwise().norm().maxCoeff(), 0.05);
}

TEST(Smooth, LeavesABowlNearlyAsItIs) {
    const MeshArrays mesh = test::sphericalCap(30, 200, 1.2);
    const Points3 V = smoothed(mesh, 2, Progress());
    EXPECT_LT((V - mesh.V).rowwise().norm().mean(), 0.1);
}

TEST(Smooth, MovesNoPointFartherThanItsStrength) {
    const MeshArrays mesh = noisy(fold(), 3);
    for (const double strength : {0.1, 0.5, 2.0}) {
        const Points3 V = smoothed(mesh, strength, Progress());
        const double farthest = (V - mesh.V).rowwise().norm().maxCoeff();
        EXPECT_LE(farthest, strength * (1 + 1e-12));
        EXPECT_GT(farthest, 0.9 * strength);
    }
    EXPECT_EQ(smoothed(mesh, 0, Progress()), mesh.V);
}

TEST(Smooth, TakesNoiseFromARimAndKeepsItsCorners) {
    const MeshArrays flat = test::planeGrid(40, 40, 10);
    MeshArrays mesh = flat;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> part(-1, 1);
    for (int v = 0; v < mesh.V.rows(); ++v) {
        mesh.V(v, 1) += flat.V(v, 1) == 0 ? part(random) : 0;
    }
    const Points3 V = smoothed(mesh, 2, Progress());
    double before = 0, after = 0;
    for (int v = 0; v < mesh.V.rows(); ++v) {
        if (flat.V(v, 1) == 0) {
            before += std::abs(mesh.V(v, 1));
            after += std::abs(V(v, 1));
        }
    }
    EXPECT_LT(after, 0.6 * before);
    EXPECT_LT((V.row(V.rows() - 1) - flat.V.row(V.rows() - 1)).norm(), 0.05);
}

TEST(Smooth, TurnsNoTriangleOver) {
    const MeshArrays mesh = noisy(fold(), 7);  // nearly as much as an edge
    const MeshArrays after{smoothed(mesh, 5, Progress()), mesh.F};
    EXPECT_TRUE(isValidSurface(after, buildEdgeTable(after.F, static_cast<int>(after.V.rows()))));
    for (int f = 0; f < mesh.F.rows(); ++f) {
        EXPECT_GT(doubleAreaNormal(after, f).dot(doubleAreaNormal(mesh, f)), 0);
    }
}

TEST(Smooth, CancelledItMovesNothing) {
    const MeshArrays mesh = noisy(fold(), 1);
    Progress progress;
    progress.cancel();
    EXPECT_EQ(smoothed(mesh, 1, progress), mesh.V);
}

}  // namespace
}  // namespace toile
