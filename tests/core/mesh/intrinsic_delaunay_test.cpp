// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/intrinsic_delaunay.h"

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/mesh/cotangents.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

/// In [-1, 1], the same on every platform.
class Noise {
public:
    explicit Noise(unsigned seed) : engine_(seed) {}

    double operator()() { return 2.0 * engine_() / std::mt19937::max() - 1; }

private:
    std::mt19937 engine_;
};

/// A grid whose vertices are moved by up to `jitter` of a square's side, `bump` of it out of the
/// plane, and which is then pulled lengthwise by `stretch`.
MeshArrays noisyGrid(int side, double stretch, double jitter, double bump, unsigned seed) {
    MeshArrays mesh = test::planeGrid(side, side, 1);
    Noise noise(seed);
    for (int v = 0; v < mesh.V.rows(); ++v) {
        mesh.V.row(v) += Eigen::RowVector3d(jitter * noise(), jitter * noise(), bump * noise());
    }
    mesh.V.col(0) *= stretch;
    return mesh;
}

IntrinsicDelaunay delaunay(const MeshArrays& mesh) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    const auto result = intrinsicDelaunay(mesh, table, Progress());
    EXPECT_TRUE(result);
    EXPECT_TRUE(result->complete);
    EXPECT_TRUE(result->graph.weights.allFinite());
    return *result;
}

WeightedEdges plain(const MeshArrays& mesh) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    return {table.edges, cotangentWeights(mesh, table)};
}

/// 1/2 sum of w (u_i - u_j)^2 over all edges.
double energy(const WeightedEdges& graph, const Eigen::VectorXd& u) {
    double sum = 0;
    for (int e = 0; e < graph.edges.rows(); ++e) {
        sum += 0.5 * graph.weights[e] * std::pow(u[graph.edges(e, 0)] - u[graph.edges(e, 1)], 2);
    }
    return sum;
}

Eigen::VectorXd laplacian(const WeightedEdges& graph, const Eigen::VectorXd& u) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(u.size());
    for (int e = 0; e < graph.edges.rows(); ++e) {
        const double flow = graph.weights[e] * (u[graph.edges(e, 0)] - u[graph.edges(e, 1)]);
        result[graph.edges(e, 0)] += flow;
        result[graph.edges(e, 1)] -= flow;
    }
    return result;
}

std::set<int> boundaryOf(const MeshArrays& mesh) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    std::set<int> boundary;
    for (int e = 0; e < table.edges.rows(); ++e) {
        if (table.useStart[e + 1] - table.useStart[e] == 1) {
            boundary.insert({table.edges(e, 0), table.edges(e, 1)});
        }
    }
    return boundary;
}

/// Edges that an equation of an interior vertex contains are not negative, and in order.
void expectNonNegative(const WeightedEdges& graph, const std::set<int>& boundary) {
    for (int e = 0; e < graph.edges.rows(); ++e) {
        const int a = graph.edges(e, 0);
        const int b = graph.edges(e, 1);
        EXPECT_LT(a, b);
        if (e > 0) {
            EXPECT_LT(std::pair(graph.edges(e - 1, 0), graph.edges(e - 1, 1)), std::pair(a, b));
        }
        if (!boundary.contains(a) || !boundary.contains(b)) {
            EXPECT_GE(graph.weights[e], 0) << a << " " << b;
        }
    }
}

TEST(IntrinsicDelaunay, LeavesADelaunayMeshAsItIs) {
    // The corners of a square, or of a strip of a cone, lie on a circle: at the limit.
    for (const MeshArrays& mesh :
         {test::planeGrid(7, 5, 3.7), test::coneSector(9, 9, 20, 60, 1, 0.5),
          test::cubeOpenedAlongH()}) {
        const IntrinsicDelaunay result = delaunay(mesh);
        const WeightedEdges expected = plain(mesh);
        ASSERT_EQ(result.flips, 0);
        EXPECT_TRUE((result.graph.edges.array() == expected.edges.array()).all());
        EXPECT_TRUE((result.graph.weights.array() == expected.weights.array()).all());
    }
}

TEST(IntrinsicDelaunay, TurnsTheLongDiagonalOfARhombus) {
    MeshArrays rhombus{Points3(4, 3), Triangles(2, 3)};
    rhombus.V << -3, 0, 0, 3, 0, 0, 0, 1, 0, 0, -1, 0;
    rhombus.F << 0, 1, 2, 1, 0, 3;
    const IntrinsicDelaunay result = delaunay(rhombus);
    EXPECT_EQ(result.flips, 1);
    Edges expected(5, 2);
    expected << 0, 2, 0, 3, 1, 2, 1, 3, 2, 3;
    ASSERT_EQ(result.graph.edges.rows(), 5);
    EXPECT_TRUE((result.graph.edges.array() == expected.array()).all());
    // Angles at 0 and 1: 2 atan(1/3), of cotangent 4/3; at 2 and 3: atan(3), of cotangent 1/3.
    Eigen::VectorXd weights(5);
    weights << 1.0 / 6, 1.0 / 6, 1.0 / 6, 1.0 / 6, 4.0 / 3;
    EXPECT_LE((result.graph.weights - weights).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(IntrinsicDelaunay, TurnsWithinABentSurfaceToo) {
    // The same rhombus folded along its long diagonal by a right angle.
    MeshArrays rhombus{Points3(4, 3), Triangles(2, 3)};
    rhombus.V << -3, 0, 0, 3, 0, 0, 0, 1, 0, 0, 0, 1;
    rhombus.F << 0, 1, 2, 1, 0, 3;
    const IntrinsicDelaunay result = delaunay(rhombus);
    EXPECT_EQ(result.flips, 1);
    EXPECT_NEAR(result.graph.weights[4], 4.0 / 3, 1e-14);
}

TEST(IntrinsicDelaunay, SumsParallelEdgesAndDropsLoops) {
    // Three triangles around the tip of a cone of 60 degrees; of the three rays one is short. Both
    // long rays are turned: the tip keeps one edge, inside a loop around it.
    const double apart = std::numbers::pi / 9;
    const double sine = std::sqrt((1 - std::cos(apart)) / 1.5);
    MeshArrays cone{Points3(4, 3), Triangles(3, 3)};
    for (int k = 0; k < 3; ++k) {
        const double turn = 2 * std::numbers::pi * k / 3;
        cone.V.row(k + 1) =
            (k == 0 ? 1 : 10) * Eigen::RowVector3d(sine * std::cos(turn), sine * std::sin(turn),
                                                   std::sqrt(1 - sine * sine));
    }
    cone.V.row(0).setZero();
    cone.F << 0, 1, 2, 0, 2, 3, 0, 3, 1;
    const IntrinsicDelaunay result = delaunay(cone);
    EXPECT_EQ(result.flips, 2);
    Edges expected(4, 2);
    expected << 0, 1, 1, 2, 1, 3, 2, 3;
    ASSERT_EQ(result.graph.edges.rows(), 4);
    EXPECT_TRUE((result.graph.edges.array() == expected.array()).all());
    EXPECT_NEAR(result.graph.weights[0], std::tan(std::numbers::pi / 6), 1e-13);
}

TEST(IntrinsicDelaunay, ReproducesLinearFunctionsOnBadMeshesOfThePlane) {
    for (const double stretch : {1.0, 5.0, 40.0}) {
        const MeshArrays mesh = noisyGrid(20, stretch, 0.2, 0, 7);
        const std::set<int> boundary = boundaryOf(mesh);
        const IntrinsicDelaunay result = delaunay(mesh);
        EXPECT_GT(result.flips, 0);
        expectNonNegative(result.graph, boundary);
        double area = 0;
        for (int f = 0; f < mesh.F.rows(); ++f) {
            const Eigen::Vector3d a = mesh.V.row(mesh.F(f, 1)) - mesh.V.row(mesh.F(f, 0));
            const Eigen::Vector3d b = mesh.V.row(mesh.F(f, 2)) - mesh.V.row(mesh.F(f, 0));
            area += 0.5 * a.cross(b).norm();
        }
        EXPECT_NEAR(energy(result.graph, mesh.V.col(0)) + energy(result.graph, mesh.V.col(1)), area,
                    1e-12 * area);
        for (const int axis : {0, 1}) {
            const Eigen::VectorXd image = laplacian(result.graph, mesh.V.col(axis));
            for (int v = 0; v < image.size(); ++v) {
                if (!boundary.contains(v)) {
                    EXPECT_NEAR(image[v], 0, 1e-11 * stretch);
                }
            }
        }
    }
}

TEST(IntrinsicDelaunay, IsNonNegativeOnBumpyMeshesAndNeverRaisesAnEnergy) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(seed);
        const MeshArrays mesh = noisyGrid(16, seed % 2 == 0 ? 9 : 1, 0.4, 0.6, seed);
        const IntrinsicDelaunay result = delaunay(mesh);
        const WeightedEdges before = plain(mesh);
        EXPECT_GT(result.flips, 0);
        EXPECT_LT(before.weights.minCoeff(), -0.1);
        expectNonNegative(result.graph, boundaryOf(mesh));
        Noise noise(seed + 100);
        for (int trial = 0; trial < 20; ++trial) {  // [Rippa 1990]
            Eigen::VectorXd u(mesh.V.rows());
            for (double& value : u) {
                value = noise();
            }
            EXPECT_LE(energy(result.graph, u), energy(before, u) * (1 + 1e-12));
        }
    }
}

TEST(IntrinsicDelaunay, DoesNotDependOnTheSizeAndComesOutTheSameAgain) {
    MeshArrays mesh = noisyGrid(16, 4, 0.4, 0.6, 3);
    const IntrinsicDelaunay result = delaunay(mesh);
    const IntrinsicDelaunay again = delaunay(mesh);
    EXPECT_TRUE((result.graph.weights.array() == again.graph.weights.array()).all());
    mesh.V *= 1024;  // a power of two: not one bit of a ratio changes
    const IntrinsicDelaunay large = delaunay(mesh);
    EXPECT_EQ(large.flips, result.flips);
    EXPECT_TRUE((result.graph.weights.array() == large.graph.weights.array()).all());
}

TEST(IntrinsicDelaunay, SurvivesNeedles) {
    for (const double height : {1e-4, 1e-8, 1e-10}) {
        SCOPED_TRACE(height);
        // Every second row of vertices lies next to the one below it.
        MeshArrays mesh = noisyGrid(10, 1, 0.2, 0.3, 11);
        for (int v = 0; v < mesh.V.rows(); ++v) {
            if (v / 11 % 2 == 1) {
                mesh.V.row(v) = mesh.V.row(v - 11) + height * Eigen::RowVector3d(0.3, 1, 0.2);
            }
        }
        const IntrinsicDelaunay result = delaunay(mesh);
        EXPECT_GT(result.flips, 0);
        expectNonNegative(result.graph, boundaryOf(mesh));
    }
}

TEST(IntrinsicDelaunay, NeedsFewFlipsPerEdge) {
    // Sheared by fifty squares' sides and stretched: the worst found needs 4.
    MeshArrays mesh = noisyGrid(60, 1, 0.2, 0, 5);
    mesh.V.col(0) = 100 * (mesh.V.col(0) + 50 * mesh.V.col(1)).eval();
    const IntrinsicDelaunay result = delaunay(mesh);
    EXPECT_LT(result.flips, 5 * result.graph.edges.rows());
}

TEST(IntrinsicDelaunay, CanBeCancelled) {
    const MeshArrays mesh = noisyGrid(200, 30, 0.2, 0, 5);
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    Progress progress;
    progress.cancel();
    const auto result = intrinsicDelaunay(mesh, table, progress);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace toile
