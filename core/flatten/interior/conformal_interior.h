// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/interior/interior.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/intrinsic_delaunay.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Flips edges near the given faces, and only there, until the surface of these faces and some
/// rings around them is Delaunay (intrinsic_delaunay.h); its rim stays. The result is the Laplacian
/// of the same surface, differing from the mesh's own in a few rows; sorted, each pair of vertices
/// once.
/// @param own    cotangentWeights(mesh, table)
/// @param faces  indices into mesh.F
/// @param rings  faces at a corner of the given ones form the first ring, and so on
/// Precondition: no degenerate triangles. Errors: Cancelled. Cost: some linear passes, and
/// `intrinsicDelaunay` of the part. Deterministic. Re-entrant.
Result<IntrinsicDelaunay> delaunayAround(const MeshArrays& mesh, const EdgeTable& table,
                                         const Eigen::VectorXd& own, const std::vector<int>& faces,
                                         int rings, const Progress& progress);

struct Piece;

/// Places the interior of a piece by conformal (cotangent) weights with the outline held, [DMA02]
/// section 4. The mesh's own weights come first: they give the published figures, and suffice for
/// most pieces. Weights of obtuse triangles may be negative, and then triangles may flip. Around
/// those the weights of the surface's Delaunay triangulation (`delaunayAround`) are used if they do
/// better; they are used everywhere (intrinsic_delaunay.h) if the own weights give no positive
/// definite system. They are no guarantee: a non-convex outline can flip triangles with any
/// weights, and long needles, which are no triangles of that triangulation, may flip even more
/// often.
/// Holds the piece by reference. One thread at a time.
class ConformalInterior {
public:
    /// Errors: FactorisationFailed (with both weights), OutOfMemory, Cancelled. Cost: one
    /// factorisation; two if the first fails.
    static Result<ConformalInterior> make(const Piece& piece, const Progress& progress);

    /// `InteriorSystem::solve`; uses the other weights if the result is not finite.
    /// Errors: NotFinite, FactorisationFailed, OutOfMemory, Cancelled.
    Result<Eigen::MatrixXd> solve(const Eigen::MatrixXd& b, const Progress& progress);
    /// `InteriorSystem::apply`, with the weights of the last `solve`.
    Eigen::MatrixXd apply(const Eigen::MatrixXd& u) const { return system_.apply(u); }

    /// Points at all vertices (#V x 2) from those of the outline (row i: boundary vertex i).
    /// Errors: NotFinite, FactorisationFailed, OutOfMemory, Cancelled. Cost: two
    /// back-substitutions; if triangles flip, another factorisation and two more.
    Result<Points2> place(const Points2& outline, const Progress& progress);

    /// Values at all vertices from those of the outline, by the weights now in use, regardless of
    /// flipped triangles. Errors: NotFinite, OutOfMemory.
    Result<Points2> extend(const Points2& onOutline) const { return system_.extend(onOutline); }

    /// Edges flipped for the weights now in use; 0: the mesh's own.
    int delaunayFlips() const { return delaunayFlips_; }

private:
    explicit ConformalInterior(const Piece& piece) : piece_(&piece) {}

    Result<ConformalInterior> withDelaunayWeights(const std::vector<int>& faces,
                                                  const Progress& progress) const;

    const Piece* piece_;
    InteriorSystem system_;
    int delaunayFlips_ = 0;
};

}  // namespace toile
