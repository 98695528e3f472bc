// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/linalg/edited_cholesky.h"
#include "core/linalg/nearby_solver.h"
#include "core/linalg/sparse_cholesky.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"
#include "core/mesh/weighted_edges.h"

namespace toile {

/// The Laplace equation with the boundary held: sum_j w_ij (q_j - q_i) = 0 at every interior
/// vertex, [DMA02] section 4. One sparse Cholesky factorisation, kept, so that several right-hand
/// sides (x and y, or the curvature) cost a back-substitution each. One thread at a time: `extend`
/// and `solve` use its workspace, and may factorise. Copies share the factor.
class InteriorSystem {
public:
    /// @param boundary  the loop of held vertices  @param vertexCount  all vertices, #V
    /// Errors: FactorisationFailed, OutOfMemory, Cancelled. Cost: one factorisation.
    static Result<InteriorSystem> make(WeightedEdges graph, int vertexCount,
                                       const std::vector<int>& boundary, const Progress& progress);

    /// The same for a piece that differs little from that of an earlier system, by its factor: a
    /// dart, a moved cut, a dragged vertex (edited_cholesky.h). Solutions are those of `make` to
    /// rounding: their residual is looked at, and where it is not at rounding level, they are
    /// refined, or the system is factorised after all.
    /// @param before        made by `make`; shares its factor, which several may do at a time
    /// @param vertexBefore  per vertex the one of the earlier piece, or -1: a hint; see
    ///                      interior_edit.h
    /// Errors: FactorisationFailed where the two differ by too much, or where the weights do so
    /// among themselves that it takes `make` to say whether they can be factorised; Cancelled.
    /// Cost: some linear passes.
    static Result<InteriorSystem> makeFrom(const InteriorSystem& before,
                                           const std::vector<int>& vertexBefore,
                                           WeightedEdges graph, int vertexCount,
                                           const std::vector<int>& boundary,
                                           const Progress& progress);

    /// The same again for other weights, which differ from those of `before` in few places, on the
    /// very same vertices with the same ones held.
    /// @param before  made by `make` or `makeFrom`; its factor is shared, or its edit, which is not
    ///                made anew
    /// Errors, cost: those of `makeFrom`.
    static Result<InteriorSystem> makeNear(const InteriorSystem& before, WeightedEdges graph,
                                           const Progress& progress);

    const WeightedEdges& graph() const { return graph_; }

    /// True where the factor is this very system's: made by `make`, or in a `solve` since.
    bool ownsFactor() const { return cholesky_ != nullptr; }

    /// About what the factor takes in memory; 0 where it is another system's.
    std::size_t factorBytes() const;

    /// Values at all vertices (#V x k) from those on the boundary (row i: boundary vertex i).
    /// @param start  of a system by `makeNear`: what `before` gave, which saves a
    /// back-substitution;
    ///               or null
    /// Errors: those of `solve`.
    Result<Eigen::MatrixXd> extend(const Eigen::MatrixXd& onBoundary,
                                   const Progress& progress = Progress(),
                                   const Eigen::MatrixXd* start = nullptr);

    /// L u = b at the interior vertices, u = 0 on the boundary; L = -sum_j w_ij (u_j - u_i). Rows
    /// of b at boundary vertices are not looked at. #V x k both.
    /// Errors: OutOfMemory, NotFinite; of a system by `makeFrom` also those of `make`, since it may
    /// have to be factorised now.
    /// @param progress  of such a factorisation
    Result<Eigen::MatrixXd> solve(const Eigen::MatrixXd& b, const Progress& progress = Progress());

    /// L u at every vertex, the boundary's included. #V x k.
    Eigen::MatrixXd apply(const Eigen::MatrixXd& u) const;

private:
    static InteriorSystem numbered(WeightedEdges graph, int vertexCount,
                                   const std::vector<int>& boundary);
    Result<void> factorise(const Progress& progress);
    Eigen::VectorXd diagonal() const;
    Result<void> holdDiagonal();
    Eigen::MatrixXd boundaryTerms(const Eigen::MatrixXd& onBoundary) const;
    Result<Eigen::MatrixXd> solveAt(const Eigen::MatrixXd& b, const Progress& progress,
                                    const Eigen::MatrixXd* start);
    Result<Eigen::MatrixXd> solveUnknowns(const Eigen::MatrixXd& right, const Progress& progress,
                                          const Eigen::MatrixXd* start);
    Eigen::MatrixXd solveEdited(const Eigen::MatrixXd& right, bool isOfTheChange = false) const;
    Eigen::MatrixXd residualOf(const Eigen::MatrixXd& x, const Eigen::MatrixXd& right) const;
    bool isFine(const Eigen::MatrixXd& residual, const Eigen::MatrixXd& x,
                const Eigen::MatrixXd& right) const;

    WeightedEdges graph_;
    std::vector<int> boundary_;
    std::vector<int> interior_;                 ///< vertex of each unknown
    std::vector<int> interiorIndex_;            ///< unknown of each vertex, -1 on the boundary
    Eigen::VectorXd diagonal_;                  ///< of the matrix, of an edited system only
    std::shared_ptr<SparseCholesky> cholesky_;  ///< null where `edited_` takes its place
    std::shared_ptr<const EditedCholesky> edited_;
    std::shared_ptr<const NearbySolver> nearby_;  ///< on top of `edited_`, or null
    std::vector<int> editedRow_;                  ///< of each unknown, in the edited system
    int editedSize_ = 0;
};

/// Places the interior of a piece by conformal (cotangent) weights with the boundary held.
/// @param boundary  the loop; its i-th vertex is held at outline row i (mm)
/// @return #V x 2, mm
/// Errors: FactorisationFailed, OutOfMemory, NotFinite, Cancelled (checked before each stage). No
/// guarantee against flipped triangles: the outline is not convex in general. Cost: one
/// factorisation, two back-substitutions. Re-entrant.
Result<Points2> fillInterior(const MeshArrays& mesh, const EdgeTable& table,
                             const std::vector<int>& boundary, const Points2& outline,
                             const Progress& progress);

}  // namespace toile
