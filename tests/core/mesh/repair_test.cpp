// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/repair.h"

#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/core/mesh/repair_support.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using test::meshOf;

/// Repairs the mesh and checks what every repair promises.
RepairResult repaired(const MeshArrays& mesh) {
    RepairResult result = repair(test::asPart(mesh), "sleeve");
    test::expectOrientedManifold(result.part.mesh);
    test::expectSources(result.part, mesh);
    for (const Error& note : result.repairs) {
        EXPECT_EQ(note.subject.name, "sleeve");
        EXPECT_TRUE(isNote(note.code));
    }
    return result;
}

/// A bent panel in which every inner vertex is doubled, two needles joining it to its double: these
/// are about so long, in parts of the other edges, and lie in all directions.
MeshArrays needles(int side, double length) {
    MeshArrays mesh = test::bentPanel(side);
    const double edge = 600.0 / side;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> part(0.2, 3), angle(0, 2 * std::numbers::pi);
    const DiskCheck whole = checkDisk(mesh, "panel");
    std::vector<char> onRim(static_cast<std::size_t>(mesh.V.rows()), 0);
    for (const int v : whole.boundary) {
        onRim[v] = 1;
    }
    const auto inner = static_cast<int>(mesh.V.rows());
    for (int v = 0; v < inner; ++v) {
        if (onRim[v] == 0) {  // uneven, so that needles of all proportions meet
            mesh.V.row(v).head(2) +=
                0.15 * edge * Eigen::RowVector2d(part(random) - 1.6, part(random) - 1.6);
        }
    }
    for (int v = 0; v < inner; ++v) {
        if (onRim[v] != 0) {
            continue;
        }
        std::map<int, std::pair<int, int>> star;  // from a neighbour: the next one, and the face
        for (int f = 0; f < mesh.F.rows(); ++f) {
            for (int k = 0; k < 3; ++k) {
                if (mesh.F(f, k) == v) {
                    star[mesh.F(f, (k + 1) % 3)] = {mesh.F(f, (k + 2) % 3), f};
                }
            }
        }
        const auto twin = static_cast<int>(mesh.V.rows());
        const double far = length * edge * part(random), turn = angle(random);
        mesh.V.conservativeResize(twin + 1, 3);
        mesh.V.row(twin) =
            mesh.V.row(v) + far * Eigen::RowVector3d(std::cos(turn), std::sin(turn), 0);
        const auto start = static_cast<std::ptrdiff_t>(random() % star.size());
        const int first = std::next(star.begin(), start)->first;
        int last = first;
        for (std::size_t k = 0; k < star.size() / 2; ++k) {
            const auto [next, face] = star.at(last);
            for (int c = 0; c < 3; ++c) {
                mesh.F(face, c) = mesh.F(face, c) == v ? twin : mesh.F(face, c);
            }
            last = next;
        }
        mesh.F.conservativeResize(mesh.F.rows() + 2, 3);
        mesh.F.bottomRows(2) << first, twin, v, last, v, twin;
    }
    return mesh;
}

// Needles of 1e-11 were refused where those of 1e-9 and of 1e-13 were repaired: all around was as
// flat, and each face without height was given to another.
TEST(Repair, ANeedleIsNoWorseThanALongerOrAShorterOne) {
    int collapsed = 0;
    for (double length = 1e-7; length > 1e-15; length /= std::sqrt(10.0)) {
        SCOPED_TRACE(length);
        const RepairResult result = repaired(needles(20, length));
        const int now = test::countOf(result.repairs, ErrorCode::EdgesCollapsed);
        EXPECT_GE(now, collapsed);
        collapsed = now;
    }
    EXPECT_EQ(collapsed, 361);  // all
}

TEST(Repair, LeavesACleanMeshAsItIs) {
    for (const MeshArrays& mesh :
         {test::planeGrid(5, 4, 10), test::sphericalCap(5, 100, 1), test::octahedron(),
          test::tube(9, 4), test::piercedTorus(9, 7), test::cubeOpenedAlongH(),
          test::moebiusStrip(9), test::renumber(test::saddle(6, 100, 0.01), 3).mesh}) {
        const MeshPart part = test::asPart(mesh);
        const RepairResult result = repair(part, "sleeve");
        EXPECT_TRUE(result.repairs.empty()) << test::kindsOf(result.repairs);
        EXPECT_EQ(result.part.mesh.V, mesh.V);
        EXPECT_EQ(result.part.mesh.F, mesh.F);
        EXPECT_EQ(result.part.sourceVertex, part.sourceVertex);
        EXPECT_EQ(result.part.sourceFace, part.sourceFace);
    }
    EXPECT_TRUE(repair({}, "nothing").repairs.empty());
}

TEST(Repair, LeavesOutFacesThatAreNone) {
    MeshArrays mesh = meshOf({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {5, 5, 5}, {7, 7, 7}},
                             {{0, 1, 1}, {0, 1, 2}, {0, 2, 3}, {1, 2, 4}});
    mesh.V(4, 1) = std::numeric_limits<double>::quiet_NaN();
    const RepairResult result = repaired(mesh);
    EXPECT_EQ(test::kindsOf(result.repairs),
              "non-finite-position degenerate-face-record unused-vertices");
    EXPECT_EQ(result.part.sourceFace, (std::vector<int>{1, 2}));
    EXPECT_EQ(result.part.mesh.V.rows(), 4);
}

TEST(Repair, CollapsesTheNeedleBetweenCoincidingVertices) {
    // 3 and 4 stand in one place, with a needle on either side of the edge between them.
    const MeshArrays mesh =
        meshOf({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {5, 5, 0}, {5, 5, 0}, {0, 9, 0}},
               {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {2, 5, 3}, {5, 0, 3}, {0, 4, 3}});
    const RepairResult result = repaired(mesh);
    EXPECT_EQ(test::kindsOf(result.repairs), "edges-collapsed");
    EXPECT_EQ(result.repairs[0].detail, "1 edge collapsed, at 5.0, 5.0, 0.0 mm");
    EXPECT_EQ(result.part.mesh.F.rows(), 4);
    EXPECT_EQ(result.part.sourceVertex, (std::vector<int>{0, 1, 2, 3, 5}));  // the least stays
    EXPECT_FALSE(checkDisk(result.part.mesh, "sleeve").defect);
    EXPECT_DOUBLE_EQ(test::areaOf(result.part.mesh), 81);
}

TEST(Repair, DividesTheNeighbourAtACap) {
    // 4 lies on the side 0-2 of the upper half; the lower half has it as a corner.
    const MeshArrays mesh = meshOf({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}, {2, 2, 0}},
                                   {{0, 1, 4}, {4, 1, 2}, {0, 4, 2}, {0, 2, 3}});
    const RepairResult result = repaired(mesh);
    EXPECT_EQ(test::kindsOf(result.repairs), "flat-faces-removed");
    EXPECT_EQ(result.repairs[0].detail,
              "1 triangle merged into the neighbour, at 2.0, 2.0, 0.0 mm");
    EXPECT_EQ(result.part.mesh.V, mesh.V);
    EXPECT_EQ(result.part.mesh.F.rows(), 4);
    EXPECT_EQ(result.part.sourceFace, (std::vector<int>{0, 1, 3, 3}));
    const DiskCheck check = checkDisk(result.part.mesh, "sleeve");
    EXPECT_FALSE(check.defect);
    EXPECT_EQ(check.boundary.size(), 4U);  // no hole: 4 is inside
    EXPECT_DOUBLE_EQ(test::areaOf(result.part.mesh), 64);
}

TEST(Repair, DropsACapOnTheBorder) {
    const MeshArrays mesh =
        meshOf({{0, 0, 0}, {8, 0, 0}, {4, 4, 0}, {3, 0, 0}}, {{0, 3, 2}, {3, 1, 2}, {0, 1, 3}});
    const RepairResult result = repaired(mesh);
    EXPECT_EQ(result.repairs[0].detail, "1 triangle removed at the boundary, at 3.0, 0.0, 0.0 mm");
    EXPECT_EQ(result.part.sourceFace, (std::vector<int>{0, 1}));
    EXPECT_EQ(checkDisk(result.part.mesh, "sleeve").boundary.size(), 4U);  // 0 3 1 2
}

TEST(Repair, KeepsTheBorderWhereACapsShortSidesAreBorder) {
    const MeshArrays mesh =
        meshOf({{0, 0, 0}, {8, 0, 0}, {4, 4, 0}, {3, 0, 0}}, {{0, 1, 2}, {0, 3, 1}});
    const RepairResult result = repaired(mesh);
    EXPECT_EQ(checkDisk(result.part.mesh, "sleeve").boundary.size(), 4U);
    EXPECT_EQ(result.part.mesh.F.rows(), 2);
    EXPECT_DOUBLE_EQ(test::areaOf(result.part.mesh), 16);
}

TEST(Repair, ResolvesAStackOfFlatTriangles) {
    // A fan of flat triangles over ten points of the side that two halves share.
    MeshArrays mesh{Points3(12, 3), Triangles(0, 3)};
    const auto add = [&mesh](int a, int b, int c) {
        mesh.F.conservativeResize(mesh.F.rows() + 1, 3);
        mesh.F.bottomRows(1) << a, b, c;
    };
    for (int i = 0; i < 10; ++i) {
        mesh.V.row(i) << i, 0, 0;
    }
    mesh.V.row(10) << 4, 5, 0;
    mesh.V.row(11) << 4, -5, 0;
    add(0, 9, 10);
    for (int i = 0; i < 9; ++i) {
        add(i + 1, i, 11);
    }
    for (int i = 1; i < 9; ++i) {
        add(0, i, i + 1);
    }
    const RepairResult result = repaired(mesh);
    EXPECT_EQ(test::kindsOf(result.repairs), "flat-faces-removed");
    EXPECT_EQ(test::countOf(result.repairs, ErrorCode::FlatFacesRemoved), 8);
    const DiskCheck check = checkDisk(result.part.mesh, "sleeve");
    EXPECT_FALSE(check.defect);
    EXPECT_EQ(check.boundary.size(), 4U);
    EXPECT_DOUBLE_EQ(test::areaOf(result.part.mesh), 45);
}

TEST(Repair, AFlipThatMeetsItsOwnEdgeGetsAVertex) {
    // 0 has three faces around it: the cap 0 2 1, the fold 0 1 3 over it, and 2 0 3. The edge 2-3
    // that the flip would make is there already.
    const MeshArrays mesh = meshOf({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, -1, 0}},
                                   {{0, 2, 1}, {0, 1, 3}, {2, 0, 3}, {1, 2, 4}});
    const RepairResult result = repaired(mesh);
    EXPECT_EQ(test::kindsOf(result.repairs), "flat-faces-removed vertices-added");
    EXPECT_EQ(result.part.sourceVertex.back(), -1);
    EXPECT_DOUBLE_EQ(test::areaOf(result.part.mesh), 1 + 0.5 + 0.5);
}

TEST(Repair, NothingIsLeftOfAMeshWithoutArea) {
    const MeshArrays mesh = meshOf({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {3, 3, 3}},
                                   {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}});
    const RepairResult result = repaired(mesh);
    EXPECT_EQ(test::kindsOf(result.repairs), "edges-collapsed flat-faces-removed");
    EXPECT_EQ(result.part.mesh.F.rows(), 0);
    EXPECT_EQ(result.part.mesh.V.rows(), 0);
}

TEST(Repair, KeepsOneOfDoubledFaces) {
    MeshArrays mesh = test::planeGrid(3, 3, 10);
    const Triangles F = mesh.F;
    mesh.F.conservativeResize(F.rows() + 3, 3);
    mesh.F.bottomRows(3) << F(4, 1), F(4, 2), F(4, 0),  // the same
        F(4, 1), F(4, 0), F(4, 2),                      // turned
        F(7, 2), F(7, 1), F(7, 0);
    const RepairResult result = repaired(mesh);
    EXPECT_EQ(test::kindsOf(result.repairs), "duplicate-faces-removed");
    EXPECT_EQ(test::countOf(result.repairs, ErrorCode::DuplicateFacesRemoved), 3);
    EXPECT_EQ(result.part.mesh.F, F);
}

TEST(Repair, TurnsTheSmallerPart) {
    const MeshArrays whole = test::sphericalCap(6, 100, 1);
    MeshArrays mesh = whole;
    int turned = 0;
    for (int f = 0; f < mesh.F.rows(); f += 3) {
        std::swap(mesh.F(f, 1), mesh.F(f, 2));
        ++turned;
    }
    const RepairResult result = repaired(mesh);
    EXPECT_EQ(test::kindsOf(result.repairs), "windings-turned");
    EXPECT_EQ(test::countOf(result.repairs, ErrorCode::WindingsTurned), turned);
    EXPECT_EQ(result.part.mesh.F, whole.F);
}

TEST(Repair, LeavesAOneSidedSurface) {
    MeshArrays mesh = test::moebiusStrip(12);
    std::swap(mesh.F(3, 0), mesh.F(3, 1));
    const RepairResult result = repair(test::asPart(mesh), "ribbon");
    EXPECT_TRUE(result.repairs.empty());
    EXPECT_EQ(result.part.mesh.F, mesh.F);
    EXPECT_EQ(checkDisk(result.part.mesh, "ribbon").defect->code, ErrorCode::NotOrientable);
}

TEST(Repair, GivesTheHourglassTwoWaists) {
    const MeshArrays mesh =
        meshOf({{0, 0, 5}, {1, 0, 0}, {0, 1, 0}, {0, 1, 9}, {1, 0, 9}}, {{0, 1, 2}, {0, 3, 4}});
    const RepairResult result = repaired(mesh);
    EXPECT_EQ(test::kindsOf(result.repairs), "vertices-split");
    EXPECT_EQ(result.repairs[0].detail, "1 vertex split, at 0.0, 0.0, 5.0 mm");
    EXPECT_EQ(result.part.sourceVertex, (std::vector<int>{0, 1, 2, 3, 4, 0}));
    EXPECT_EQ(result.part.mesh.F.row(0), mesh.F.row(0));
}

}  // namespace
}  // namespace toile
