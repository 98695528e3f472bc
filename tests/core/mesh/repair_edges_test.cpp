// SPDX-License-Identifier: GPL-3.0-or-later
/// Edges of more than two faces.
#include <numbers>

#include <gtest/gtest.h>

#include "tests/core/mesh/repair_support.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using test::meshOf;

/// Faces around the edge from (0,0,0) to (0,9,0), each leaving it at an angle (degrees, from +x
/// towards +z); `forward` runs along the edge.
struct Leaf {
    double angle;
    bool forward;
};

MeshArrays book(std::initializer_list<Leaf> leaves) {
    const auto count = static_cast<int>(leaves.size());
    MeshArrays mesh{Points3(count + 2, 3), Triangles(count, 3)};
    mesh.V.row(0) << 0, 0, 0;
    mesh.V.row(1) << 0, 9, 0;
    int f = 0;
    for (const Leaf& leaf : leaves) {
        const double angle = leaf.angle * std::numbers::pi / 180;
        mesh.V.row(f + 2) << 5 * std::cos(angle), 4, 5 * std::sin(angle);
        mesh.F.row(f) << (leaf.forward ? 0 : 1), (leaf.forward ? 1 : 0), f + 2;
        ++f;
    }
    return mesh;
}

/// Which leaves are still joined, as text: "02 1" for the first with the third, the second alone.
std::string joined(const MeshArrays& mesh) {
    const RepairResult result = repair(test::asPart(mesh), "book");
    test::expectOrientedManifold(result.part.mesh);
    test::expectSources(result.part, mesh);
    EXPECT_NEAR(test::areaOf(result.part.mesh), test::areaOf(mesh), 1e-9);
    const std::vector<int> label =
        faceComponents(result.part.mesh.F, static_cast<int>(result.part.mesh.V.rows()));
    std::string text;
    for (std::size_t c = 0; c < label.size(); ++c) {
        std::string group;
        for (std::size_t f = 0; f < label.size(); ++f) {
            group += label[f] == static_cast<int>(c) ? std::to_string(f) : "";
        }
        text += (text.empty() || group.empty() ? "" : " ") + group;
    }
    return text;
}

TEST(RepairEdges, TheStraightestPairStaysJoined) {
    EXPECT_EQ(joined(book({{0, true}, {90, true}, {180, false}})), "02 1");
    EXPECT_EQ(joined(book({{0, true}, {170, false}, {100, true}})), "01 2");
}

TEST(RepairEdges, OpposedWindingsCountAsARightAngle) {
    // Straight on but opposed, or bent by 60 degrees and coherent: the latter.
    EXPECT_EQ(joined(book({{0, true}, {180, true}, {120, false}})), "02 1");
    // Where all are opposed, the straightest pair again, with one of them turned.
    EXPECT_EQ(joined(book({{0, true}, {60, true}, {170, true}})), "02 1");
}

TEST(RepairEdges, CrossingSheetsComeApart) {
    EXPECT_EQ(joined(book({{0, true}, {90, true}, {180, false}, {270, false}})), "02 13");
}

TEST(RepairEdges, ManyFacesOnOneEdgeComeFree) {
    MeshArrays mesh{Points3(202, 3), Triangles(200, 3)};
    mesh.V.row(0) << 0, 0, 0;
    mesh.V.row(1) << 0, 9, 0;
    for (int f = 0; f < 200; ++f) {
        mesh.V.row(f + 2) << std::cos(0.01 * f), 4, std::sin(0.01 * f);
        mesh.F.row(f) << f % 2, 1 - f % 2, f + 2;
    }
    const RepairResult result = repair(test::asPart(mesh), "brush");
    test::expectOrientedManifold(result.part.mesh);
    EXPECT_EQ(result.part.mesh.V.rows(), 600);
}

TEST(RepairEdges, AFinLeavesTheSurfaceWhole) {
    // A roof with a fin on its ridge that goes straight on from one half.
    MeshArrays mesh = test::planeGrid(4, 4, 10);
    for (int v = 0; v < mesh.V.rows(); ++v) {
        mesh.V(v, 2) = -std::abs(mesh.V(v, 0) - 20);
    }
    const auto rows = mesh.V.rows();
    mesh.V.conservativeResize(rows + 1, 3);
    mesh.V.row(rows) << 30, 15, 10;
    mesh.F.conservativeResize(mesh.F.rows() + 1, 3);
    mesh.F.bottomRows(1) << 12, 7, static_cast<int>(rows);
    const RepairResult result = repair(test::asPart(mesh), "fin");
    EXPECT_EQ(test::kindsOf(result.repairs), "edges-cut-apart");
    const auto components = test::componentsOf(result.part.mesh);
    ASSERT_EQ(components.size(), 2U);
    EXPECT_EQ(components[0].F, test::planeGrid(4, 4, 10).F);
    EXPECT_FALSE(checkDisk(components[0], "grid").defect);
}

TEST(RepairEdges, SolidsThatTouchAlongAnEdgeStayTwo) {
    // Two cubes' corners: the octahedron and its mirror image in the line of one of its edges.
    const MeshArrays one = test::octahedron();
    MeshArrays mesh{Points3(10, 3), Triangles(16, 3)};
    mesh.V.topRows(6) = one.V;
    mesh.F.topRows(8) = one.F;
    const int a = one.F(0, 0);
    const int b = one.F(0, 1);
    const Eigen::RowVector3d foot = one.V.row(a);
    const Eigen::RowVector3d along = (one.V.row(b) - foot).normalized();
    int next = 6;
    std::vector<int> image(6);
    for (int v = 0; v < 6; ++v) {
        image[v] = v == a || v == b ? v : next++;
        const Eigen::RowVector3d p = one.V.row(v) - foot;
        mesh.V.row(image[v]) = foot + 2 * p.dot(along) * along - p;
    }
    for (int f = 0; f < 8; ++f) {
        mesh.F.row(8 + f) << image[one.F(f, 0)], image[one.F(f, 1)], image[one.F(f, 2)];
    }
    const RepairResult result = repair(test::asPart(mesh), "solids");
    EXPECT_EQ(test::kindsOf(result.repairs), "edges-cut-apart");
    const auto components = test::componentsOf(result.part.mesh);
    ASSERT_EQ(components.size(), 2U);
    for (const MeshArrays& component : components) {
        EXPECT_EQ(checkDisk(component, "solid").defect->code, ErrorCode::ClosedSurface);
    }
}

TEST(RepairEdges, AOneSidedSurfaceTakesNoSheetWithIt) {
    // A Moebius strip whose border has two fins: one goes straight on, but would become one-sided
    // with the strip. The fins stay with each other.
    MeshArrays mesh = test::moebiusStrip(12);
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    int e = 0;
    while (table.useStart[e + 1] - table.useStart[e] != 1) {
        ++e;
    }
    const int a = table.edges(e, 0);
    const int b = table.edges(e, 1);
    const int f = table.use[table.useStart[e]] / 3;
    const int apex = mesh.F.row(f).sum() - a - b;
    const Eigen::RowVector3d middle = 0.5 * (mesh.V.row(a) + mesh.V.row(b));
    const Eigen::RowVector3d on = middle - mesh.V.row(apex);
    const Eigen::RowVector3d aside = on.cross(mesh.V.row(b) - mesh.V.row(a));
    const int first = static_cast<int>(mesh.V.rows());
    mesh.V.conservativeResize(first + 2, 3);
    mesh.V.bottomRows(2) << middle + on, middle + aside;
    mesh.F.conservativeResize(mesh.F.rows() + 2, 3);
    mesh.F.bottomRows(2) << a, b, first, b, a, first + 1;
    const RepairResult result = repair(test::asPart(mesh), "ribbon");
    EXPECT_EQ(test::kindsOf(result.repairs), "edges-cut-apart");
    const auto components = test::componentsOf(result.part.mesh);
    ASSERT_EQ(components.size(), 2U);
    EXPECT_EQ(components[0].F, test::moebiusStrip(12).F);
    EXPECT_EQ(checkDisk(components[0], "ribbon").defect->code, ErrorCode::NotOrientable);
    EXPECT_FALSE(checkDisk(components[1], "fins").defect);
}

TEST(RepairEdges, ASurfaceThatComesBackToTheSameEndsGetsAVertexInBetween) {
    // A sharp wedge with a fin straight on from its lower face. The upper face 1 0 4 finds no
    // partner on the edge 0-1, but is joined to the lower one round both its ends: its border needs
    // a vertex to be an edge of its own.
    const MeshArrays mesh = meshOf({{0, 0, 0}, {0, 8, 0}, {8, 4, 0}, {-8, 4, 0}, {8, 4, 3}},
                                   {{0, 1, 2}, {1, 0, 3}, {1, 0, 4}, {0, 2, 4}, {1, 4, 2}});
    const RepairResult result = repair(test::asPart(mesh), "wedge");
    test::expectOrientedManifold(result.part.mesh);
    test::expectSources(result.part, mesh);
    EXPECT_EQ(test::kindsOf(result.repairs), "edges-cut-apart vertices-added");
    EXPECT_EQ(result.repairs[1].detail, "1 vertex added, at 0.0, 4.0, 0.0 mm");
    EXPECT_EQ(result.part.sourceFace, (std::vector<int>{0, 1, 2, 3, 4, 2}));
    EXPECT_NEAR(test::areaOf(result.part.mesh), test::areaOf(mesh), 1e-12);
    EXPECT_FALSE(checkDisk(result.part.mesh, "wedge").defect);
}

}  // namespace
}  // namespace toile
