// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/flatten/flatten.h"
#include "core/flatten/interior/directed_interior.h"
#include "core/flatten/interior/interior.h"
#include "core/garment/garment.h"
#include "core/quality/measures.h"
#include "core/quality/piece_quality.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/turned_triangles.h"

namespace toile {
namespace {

const FlattenOptions kConvex{Method::Convex};

/// A disk of rings in the plane, with a regular outline.
MeshArrays flatDisk(int rings) {
    MeshArrays mesh = test::sphericalCap(rings, 100, 0.9);
    mesh.V.col(1).setZero();
    return mesh;
}

TEST(MeanValue, WeightsReproduceAFlatNeighbourhood) {
    MeshArrays mesh = test::planeGrid(6, 6, 10);
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {  // uneven, with obtuse angles
        mesh.V(v, 0) += 3 * std::sin(5.0 * static_cast<double>(v));
        mesh.V(v, 1) += 3 * std::cos(3.0 * static_cast<double>(v));
    }
    const auto piece = test::asPiece(mesh);
    const DirectedEdges graph = meanValueWeights(piece->mesh, piece->table);
    EXPECT_GT(graph.weights.minCoeff(), 0);
    Points2 outline(static_cast<Eigen::Index>(piece->boundary.size()), 2);
    for (std::size_t i = 0; i < piece->boundary.size(); ++i) {
        outline.row(static_cast<Eigen::Index>(i)) = mesh.V.row(piece->boundary[i]).head<2>();
    }
    const auto Q =
        solveDirected(graph, static_cast<int>(mesh.V.rows()), piece->boundary, outline, Progress());
    ASSERT_TRUE(Q);
    EXPECT_LE((*Q - mesh.V.leftCols<2>()).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(Convex, AFlatRegularDiskKeepsItsShape) {
    const auto disk = test::asPiece(flatDisk(9));
    Progress progress;
    const auto flat = flatten(*disk, kConvex, progress);
    ASSERT_TRUE(flat) << sentence(flat.error());
    EXPECT_LE(maxRelativeLengthError(edgeLengths3d(disk->mesh.V, disk->table.edges),
                                     edgeLengths2d(flat->Q, disk->table.edges)),
              1e-11);
    EXPECT_LE(flat->angleEnergy, 1e-20);
}

TEST(Convex, KeepsBoundaryLengthsAndNeverFlips) {
    for (const MeshArrays& mesh :
         {test::planeGrid(30, 4, 10), test::cylinderSector(24, 9, 80, 2.5, 150),
          test::sphericalCap(14, 90, 2.6), test::saddle(16, 200, 1.2), test::cubeOpenedAlongH(),
          test::cubeSlitAlongOneEdge()}) {
        const auto piece = test::asPiece(mesh);
        Progress progress;
        const auto flat = flatten(*piece, kConvex, progress);
        ASSERT_TRUE(flat) << sentence(flat.error());
        const PieceQuality quality = measure(*piece, flat->Q);
        EXPECT_LE(quality.maxBoundaryLengthError, 1e-12);
        EXPECT_EQ(quality.flippedTriangles, 0);
        EXPECT_EQ(quality.outlineCrossings, 0);
        const auto tutte = tutteOnCircle(*piece, progress);
        ASSERT_TRUE(tutte) << sentence(tutte.error());
        EXPECT_GT(triangleAreas2d(*tutte, piece->mesh.F).minCoeff(), 0);
    }
}

TEST(Convex, AChordBetweenBoundaryVerticesDoesNoHarm) {
    // Two disks that share one edge: its ends lie on the outline, the edge does not.
    MeshArrays mesh = test::planeGrid(2, 1, 10);
    const auto piece = test::asPiece(mesh);
    ASSERT_EQ(piece->boundary.size(), 6);
    Progress progress;
    const auto flat = flatten(*piece, kConvex, progress);
    ASSERT_TRUE(flat);
    EXPECT_GT(triangleAreas2d(flat->Q, mesh.F).minCoeff(), 0);
}

class ConvexData : public testing::TestWithParam<const char*> {};

TEST_P(ConvexData, NeverFlips) {
    const auto file = test::dataFile(GetParam());
    TOILE_NEEDS_SHARED(file);
    Progress progress;
    const auto garment = loadGarment({file}, {LengthUnit::Metre}, progress);
    ASSERT_TRUE(garment) << sentence(garment.error());
    for (const auto& piece : garment->pieces) {
        SCOPED_TRACE(piece->name);
        const auto flat = flatten(*piece, kConvex, progress);
        ASSERT_TRUE(flat) << sentence(flat.error());
        EXPECT_EQ(test::turnedTriangles(flat->Q, piece->mesh.F), 0);
        const auto tutte = tutteOnCircle(*piece, progress);
        ASSERT_TRUE(tutte) << sentence(tutte.error());
        EXPECT_EQ(test::turnedTriangles(*tutte, piece->mesh.F), 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, ConvexData,
                         testing::Values("samples/shapes/cube-h.obj", "samples/bodice.obj",
                                         "samples/cap.obj", "samples/trousers.obj"));
INSTANTIATE_TEST_SUITE_P(Shared, ConvexData,
                         testing::Values("disks/mannequin-devil.off", "disks/lion-head.off",
                                         "disks/three_peaks.off", "disks/maze.obj",
                                         "garments/dress14_pieces.obj", "garments/tee_sim.obj"));

TEST(Convex, AnEdgeAsLongAsAllOthersIsNamed) {
    Piece piece;
    piece.mesh = {Points3(3, 3), Triangles(1, 3)};
    piece.mesh.V << 0, 0, 0, 2, 0, 0, 1, 0, 0;
    piece.mesh.F << 0, 1, 2;
    piece.table = buildEdgeTable(piece.mesh.F, 3);
    piece.boundary = {0, 1, 2};
    Progress progress;
    const auto tutte = tutteOnCircle(piece, progress);
    ASSERT_FALSE(tutte);
    EXPECT_EQ(tutte.error().code, ErrorCode::NoClosedOutline);
}

}  // namespace
}  // namespace toile
