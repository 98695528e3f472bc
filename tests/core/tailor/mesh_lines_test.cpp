// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/mesh_lines.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/core/support/shapes.h"

namespace toile {
namespace {

/// A sheet folded along x = 200 as along a seam: even there, uneven elsewhere. @param isFolded
/// else flat
MeshArrays sewnSheet() {
    MeshArrays mesh = test::planeGrid(40, 40, 10);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> shift(-3.5, 3.5);
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
        const double x = mesh.V(v, 0), y = mesh.V(v, 1);
        const bool isInside = x > 0 && x < 400 && y > 0 && y < 400;
        if (isInside && x != 200) {
            mesh.V(v, 0) += shift(random);
            mesh.V(v, 1) += shift(random);
        }
        mesh.V(v, 2) = -0.2 * std::abs(mesh.V(v, 0) - 200);
    }
    return mesh;
}

bool isOnSeam(const MeshArrays& mesh, const Edges& edges, int edge) {
    return mesh.V(edges(edge, 0), 0) == 200 && mesh.V(edges(edge, 1), 0) == 200;
}

/// How often an edge of the seam has more than another: the area under the ROC curve.
double separation(const MeshArrays& mesh) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    const SurfaceLinks links(mesh, table);
    const MeshLines lines = findMeshLines(links);
    std::vector<double> on, off;
    for (int e = 0; e < links.edgeCount(); ++e) {
        (isOnSeam(mesh, table.edges, e) ? on : off).push_back(lines.at(e));
    }
    double more = 0;
    for (const double one : on) {
        more += static_cast<double>(
            std::ranges::count_if(off, [one](double other) { return other < one; }));
    }
    return more / static_cast<double>(on.size() * off.size());
}

TEST(MeshLines, ASeamStandsOut) {
    EXPECT_GT(separation(sewnSheet()), 0.99);
}

TEST(MeshLines, LengthsAndPlaceDoNotCount) {
    MeshArrays mesh = sewnSheet();
    const double before = separation(mesh);
    const Edges edges = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows())).edges;
    const test::Renumbered other = test::renumber(mesh, 3);
    EXPECT_NEAR(separation(other.mesh), before, 1e-3);
}

TEST(MeshLines, OfARegularGridNothingStandsOut) {
    const MeshArrays mesh = test::planeGrid(30, 30, 10);
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    const SurfaceLinks links(mesh, table);
    const MeshLines lines = findMeshLines(links);
    EXPECT_LT(*std::ranges::max_element(lines.likeliness), 0.5);
    EXPECT_GE(lines.usual, 28);
}

TEST(MeshLines, RoundingIsNoBend) {
    MeshArrays mesh = test::planeGrid(30, 30, 10);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    mesh.V = mesh.V * turn.transpose();
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    const SurfaceLinks links(mesh, table);
    const MeshLines lines = findMeshLines(links);
    EXPECT_LT(*std::ranges::max_element(lines.likeliness), 0.5);
}

TEST(MeshLines, EveryEdgeIsInOneLineAndWaysAreChains) {
    const MeshArrays mesh = sewnSheet();
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    const SurfaceLinks links(mesh, table);
    const MeshLines lines = findMeshLines(links);
    std::size_t edges = 0;
    for (std::size_t line = 0; line < lines.ways.size(); ++line) {
        const std::vector<int>& way = lines.ways[line];
        edges += way.size() - 1;
        for (std::size_t k = 1; k < way.size(); ++k) {
            const int edge = findEdge(table.edges, way[k - 1], way[k]);
            ASSERT_GE(edge, 0);
            EXPECT_EQ(lines.lineOf[edge], static_cast<int>(line));
        }
    }
    EXPECT_EQ(edges, static_cast<std::size_t>(links.edgeCount()));
}

}  // namespace
}  // namespace toile
