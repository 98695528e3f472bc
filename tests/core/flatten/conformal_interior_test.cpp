// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/interior/conformal_interior.h"

#include <algorithm>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "core/flatten/flatten.h"
#include "core/mesh/cotangents.h"
#include "core/mesh/intrinsic_delaunay.h"
#include "core/quality/measures.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/turned_triangles.h"

namespace toile {
namespace {

/// A strip of 30 x 16 squares whose vertices are moved within the plane, those inside out of it too
/// (both in squares' sides), then pulled lengthwise into slivers.
MeshArrays strip(double stretch, double jitter, double bump, unsigned seed) {
    MeshArrays mesh = test::planeGrid(30, 16, 1);
    std::mt19937 engine(seed);
    const auto noise = [&engine] { return 2.0 * engine() / std::mt19937::max() - 1; };
    for (int v = 0; v < mesh.V.rows(); ++v) {
        int axis = 0;
        const bool isInside = v % 31 > 0 && v % 31 < 30 && v / 31 > 0 && v / 31 < 16;
        for (const double size : {jitter, jitter, isInside ? bump : 0}) {
            mesh.V(v, axis++) += size * noise();
        }
    }
    mesh.V.col(0) *= stretch;
    return mesh;
}

/// Flipped triangles inside the outline of a flattening, by the mesh's own weights and by those
/// that are Delaunay around the triangles which flip so.
struct Flips {
    int plain, delaunay;
    int turned;  ///< edges
};

Flips flipsByBoth(const Piece& piece, const Points2& Q) {
    Points2 outline(static_cast<Eigen::Index>(piece.boundary.size()), 2);
    for (std::size_t i = 0; i < piece.boundary.size(); ++i) {
        outline.row(static_cast<Eigen::Index>(i)) = Q.row(piece.boundary[i]);
    }
    const auto placedWith = [&](const WeightedEdges& graph) -> Points2 {
        auto system = InteriorSystem::make(graph, piece.mesh.V, piece.boundary, Progress());
        return *system->extend(outline);
    };
    const auto flippedIn = [&piece](const Points2& points) {
        return test::turnedTriangles(points, piece.mesh.F);
    };
    const Eigen::VectorXd own = cotangentWeights(piece.mesh, piece.table);
    const Points2 plain = placedWith({piece.table.edges, own});
    const Eigen::VectorXd areas = triangleAreas2d(plain, piece.mesh.F);
    std::vector<int> flipped;
    for (int f = 0; f < areas.size(); ++f) {
        if (areas[f] <= 0) {
            flipped.push_back(f);
        }
    }
    const auto around = delaunayAround(piece.mesh, piece.table, own, flipped, 2, Progress());
    return {flippedIn(plain), flippedIn(placedWith(around->graph)), around->flips};
}

TEST(ConformalInterior, KeepsTheMeshsOwnWeightsWhereNothingFlips) {
    // Slivers in the plane: the weights are as negative as they get, and the answer is exact.
    const auto piece = test::asPiece(strip(20, 0.3, 0, 1));
    EXPECT_LT(cotangentWeights(piece->mesh, piece->table).minCoeff(), -1);
    for (const Method method : {Method::Wang2005, Method::Curvature}) {
        const auto flat = flatten(*piece, {method}, Progress());
        ASSERT_TRUE(flat);
        EXPECT_EQ(flat->delaunayFlips, 0);
        EXPECT_EQ(test::turnedTriangles(flat->Q, piece->mesh.F), 0);
        EXPECT_LE(test::distanceAfterRigidMotion(flat->Q, piece->mesh.V.leftCols(2)), 1e-8);
    }
}

TEST(ConformalInterior, TakesDelaunayWeightsWhereTheOwnOnesFlip) {
    const std::pair<Method, MeshArrays> cases[] = {{Method::Wang2005, strip(2, 0.3, 1, 16)},
                                                   {Method::Curvature, strip(2, 0.3, 3, 7)}};
    for (const auto& [method, mesh] : cases) {
        SCOPED_TRACE(name(method));
        const auto piece = test::asPiece(mesh);
        const auto flat = flatten(*piece, {method}, Progress());
        ASSERT_TRUE(flat);
        const Flips flips = flipsByBoth(*piece, flat->Q);
        EXPECT_GT(flips.plain, 0);
        EXPECT_EQ(flips.delaunay, 0);
        EXPECT_EQ(test::turnedTriangles(flat->Q, piece->mesh.F), 0);
        EXPECT_EQ(flat->delaunayFlips, flips.turned);
        EXPECT_LT(flat->delaunayFlips,
                  intrinsicDelaunay(piece->mesh, piece->table, Progress())->flips);
    }
}

TEST(ConformalInterior, KeepsTheOwnWeightsWhereTheOthersFlipMore) {
    // On needles the mesh's triangles are none of the Delaunay triangulation's, and what keeps
    // those upright says nothing about these.
    int kept = 0;
    for (unsigned seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        const auto piece = test::asPiece(strip(30, 0.3, 4, seed));
        const auto flat = flatten(*piece, {Method::Curvature}, Progress());
        ASSERT_TRUE(flat);
        const Flips flips = flipsByBoth(*piece, flat->Q);
        EXPECT_EQ(test::turnedTriangles(flat->Q, piece->mesh.F),
                  std::min(flips.plain, flips.delaunay));
        EXPECT_EQ(flat->delaunayFlips > 0, flips.delaunay < flips.plain);
        kept += 0 < flips.plain && flips.plain < flips.delaunay ? 1 : 0;
    }
    EXPECT_GT(kept, 0);
}

TEST(ConformalInterior, IsCancelledOnTheWay) {
    const auto piece = test::asPiece(strip(2, 0.3, 3, 7));
    Progress progress;
    auto interior = ConformalInterior::make(*piece, progress);
    ASSERT_TRUE(interior);
    const auto flat = flatten(*piece, {Method::Curvature}, Progress());
    Points2 outline(static_cast<Eigen::Index>(piece->boundary.size()), 2);
    for (std::size_t i = 0; i < piece->boundary.size(); ++i) {
        outline.row(static_cast<Eigen::Index>(i)) = flat->Q.row(piece->boundary[i]);
    }
    progress.cancel();
    const auto points = interior->place(outline, progress);
    ASSERT_FALSE(points);
    EXPECT_EQ(points.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace toile
