// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/outline_targets.h"
#include "core/linalg/sparse_cholesky.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

struct Piece;

/// Numbers of the vertices that are not held, in vertex order; -1 for held ones.
std::vector<int> unknownsBut(std::span<const int> held, int vertexCount);

/// The Laplace equation with the boundary held: sum_j w_ij (q_j - q_i) = 0 at every interior
/// vertex, [DMA02] section 4. Stores one sparse Cholesky factorisation, so that several right-hand
/// sides (x and y, or the curvature) cost a back-substitution each. Immutable: any number of
/// threads may solve with it.
class InteriorSystem {
public:
    /// @param V  positions of the vertices, for the elimination order of large systems
    /// @param boundary  the loop of held vertices
    /// Errors: FactorisationFailed, OutOfMemory, Cancelled. Cost: one factorisation.
    static Result<InteriorSystem> make(WeightedEdges graph, const Points3& V,
                                       const std::vector<int>& boundary, const Progress& progress);

    const WeightedEdges& graph() const { return graph_; }

    /// Points at all vertices (#V x 2) from those on the boundary (row i: boundary vertex i).
    /// Errors: those of `solve`.
    Result<Points2> extend(const Points2& onBoundary) const;

    /// L u = b at the interior vertices, u = 0 on the boundary; L = -sum_j w_ij (u_j - u_i). Rows
    /// of b at boundary vertices are ignored. #V x k both.
    /// Errors: OutOfMemory, NotFinite.
    Result<Eigen::MatrixXd> solve(const Eigen::MatrixXd& b) const;

    /// L u at every vertex, the boundary's included. #V x k.
    Eigen::MatrixXd apply(const Eigen::MatrixXd& u) const;

private:
    Result<void> factorise(const Points3& V, const Progress& progress);

    WeightedEdges graph_;
    std::vector<int> boundary_;
    std::vector<int> interior_;       ///< vertex of each unknown
    std::vector<int> interiorIndex_;  ///< unknown of each vertex, -1 on the boundary
    linalg::SparseCholesky cholesky_;
};

/// Places the interior of a piece by symmetric weights with the boundary held.
/// @param graph  cotangent weights: the conformal interior
/// @param boundary  the loop; its i-th vertex is held at outline row i (mm)
/// @return #V x 2, mm
/// Errors: FactorisationFailed, OutOfMemory, NotFinite, Cancelled (checked before each stage). No
/// guarantee against flipped triangles: the outline is not convex in general. Cost: one
/// factorisation, two back-substitutions. Re-entrant.
Result<Points2> fillInterior(WeightedEdges graph, const Points3& V,
                             const std::vector<int>& boundary, const Points2& outline,
                             const Progress& progress);

/// Tutte's embedding [Tut63] with the outline's lengths: the outline of `circleOutline`,
/// every interior vertex at the mean of its neighbours. The outline is strictly convex and the
/// weights are positive, so no triangle is flipped in exact arithmetic; a chord
/// between boundary vertices does no harm. In doubles, triangles far from a short boundary can
/// become smaller than rounding: count flips where that matters.
/// @param piece  a disk (no defect, holes filled), mm  @return #V x 2, mm
/// Errors: NoClosedOutline, FactorisationFailed, OutOfMemory, NotFinite, Cancelled.
/// Cost: one factorisation of the interior, two back-substitutions. Re-entrant.
Result<Points2> tutteOnCircle(const Piece& piece, const Progress& progress,
                              const OutlineTargets& targets = {});

}  // namespace toile
