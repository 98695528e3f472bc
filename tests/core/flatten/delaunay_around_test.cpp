// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/flatten/interior/conformal_interior.h"
#include "core/mesh/cotangents.h"
#include "core/mesh/intrinsic_delaunay.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

/// A bumpy strip with many obtuse triangles.
MeshArrays obtuseStrip(unsigned seed) {
    MeshArrays mesh = test::planeGrid(20, 12, 1);
    std::mt19937 random(seed);
    for (int v = 0; v < mesh.V.rows(); ++v) {
        for (int axis = 0; axis < 3; ++axis) {
            mesh.V(v, axis) += 0.3 * (2.0 * random() / std::mt19937::max() - 1);
        }
    }
    mesh.V.col(0) *= 2;
    return mesh;
}

std::map<std::pair<int, int>, double> entries(const WeightedEdges& graph) {
    std::map<std::pair<int, int>, double> all;
    for (int e = 0; e < graph.edges.rows(); ++e) {
        EXPECT_TRUE(
            all.emplace(std::pair(graph.edges(e, 0), graph.edges(e, 1)), graph.weights[e]).second);
        EXPECT_LT(graph.edges(e, 0), graph.edges(e, 1));
    }
    return all;
}

double energy(const WeightedEdges& graph, const Eigen::VectorXd& u) {
    double sum = 0;
    for (int e = 0; e < graph.edges.rows(); ++e) {
        const double step = u[graph.edges(e, 0)] - u[graph.edges(e, 1)];
        sum += graph.weights[e] * step * step;
    }
    return sum;
}

Eigen::VectorXd randomValues(Eigen::Index count, std::mt19937& random) {
    return Eigen::VectorXd::NullaryExpr(
        count, [&random]() -> double { return 1.0 * random() / std::mt19937::max(); });
}

TEST(DelaunayAround, LeavesTheRestAsItIs) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        const MeshArrays mesh = obtuseStrip(seed);
        const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
        const Eigen::VectorXd own = cotangentWeights(mesh, table);
        const auto around = delaunayAround(mesh, table, own, {50, 51, 300}, 1, Progress());
        ASSERT_TRUE(around);
        EXPECT_GT(around->flips, 0);
        // Vertices of the ring, by its definition.
        std::vector<char> isCorner(static_cast<std::size_t>(mesh.V.rows()), 0);
        for (const int f : {50, 51, 300}) {
            for (const int v : mesh.F.row(f)) {
                isCorner[v] = 1;
            }
        }
        std::vector<char> isInPart(isCorner);
        for (int f = 0; f < mesh.F.rows(); ++f) {
            const auto corners = mesh.F.row(f);
            if (isCorner[corners[0]] + isCorner[corners[1]] + isCorner[corners[2]] > 0) {
                for (const int v : corners) {
                    isInPart[v] = 1;
                }
            }
        }
        const auto before = entries({table.edges, own});
        const auto changed = entries(around->graph);
        for (int e = 0; e < table.edges.rows(); ++e) {
            const int a = table.edges(e, 0);
            const int b = table.edges(e, 1);
            if (isInPart[a] == 0 || isInPart[b] == 0) {
                ASSERT_TRUE(changed.contains({a, b}));
                EXPECT_EQ(changed.at({a, b}), own[e]);
            }
        }
        for (const auto& [ends, weight] : changed) {
            const bool isNew = isInPart[ends.first] != 0 && isInPart[ends.second] != 0;
            EXPECT_TRUE(isNew || before.contains(ends));
        }
    }
}

TEST(DelaunayAround, HasAnEnergyBetweenTheOwnAndTheDelaunayOne) {
    std::mt19937 random(7);
    for (unsigned seed = 0; seed < 10; ++seed) {
        const MeshArrays mesh = obtuseStrip(seed);
        const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
        const Eigen::VectorXd own = cotangentWeights(mesh, table);
        const auto delaunay = intrinsicDelaunay(mesh, table, Progress());
        for (int rings = 0; rings < 4; ++rings) {
            const auto around = delaunayAround(mesh, table, own, {60, 200, 201}, rings, Progress());
            for (int k = 0; k < 20; ++k) {
                const Eigen::VectorXd u = randomValues(mesh.V.rows(), random);
                const double most = energy({table.edges, own}, u);
                EXPECT_LE(energy(around->graph, u), most * (1 + 1e-12));
                EXPECT_GE(energy(around->graph, u), energy(delaunay->graph, u) * (1 - 1e-12));
            }
        }
    }
}

TEST(DelaunayAround, IsTheDelaunayTriangulationWhereItTakesTheWholeMesh) {
    const MeshArrays mesh = obtuseStrip(3);
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    const Eigen::VectorXd own = cotangentWeights(mesh, table);
    const auto delaunay = intrinsicDelaunay(mesh, table, Progress());
    const auto around = delaunayAround(mesh, table, own, {0}, 40, Progress());
    EXPECT_EQ(around->flips, delaunay->flips);
    EXPECT_EQ(around->graph.edges, delaunay->graph.edges);
    EXPECT_LE((around->graph.weights - delaunay->graph.weights).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(DelaunayAround, TurnsNothingOnADelaunayMesh) {
    const MeshArrays mesh = test::planeGrid(6, 6, 1);
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    const Eigen::VectorXd own = cotangentWeights(mesh, table);
    const auto around = delaunayAround(mesh, table, own, {10, 20}, 2, Progress());
    EXPECT_EQ(around->flips, 0);
    EXPECT_EQ(around->graph.edges, table.edges);
    EXPECT_EQ(around->graph.weights, own);
}

}  // namespace
}  // namespace toile
