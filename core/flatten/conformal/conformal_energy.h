// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/garment/piece.h"
#include "core/linalg/sparse_cholesky.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The conformal energy with a free boundary, E(z) = 1/2 sum over triangles |(M z)_T|^2, where z =
/// x + i y are the planar points as complex numbers. Row T of M holds e_k / (2 sqrt(A)) at the
/// triangle's k-th corner, e_k the edge opposite to it in the triangle's own plane, A its area.
/// That is the least squares form of [LPRM02]; summed up it is the Dirichlet energy minus the
/// signed area, [DMA02]'s natural boundary and [MTAD08]'s L_C. Stored by triangle, because this
/// gives M z to full precision, while a sum over the edges cancels.
class ConformalEnergy {
public:
    /// Triangles as in 3D. Precondition: none degenerate.
    explicit ConformalEnergy(const MeshArrays& mesh);

    /// Triangles of the given corner angles (#F x 3, radians, in (0, pi)), of any size: similar
    /// triangles have the same row.
    ConformalEnergy(const Triangles& F, const Eigen::MatrixX3d& angles, int vertexCount);

    int vertexCount() const { return vertexCount_; }

    /// M z: #F, from #V.
    Eigen::VectorXcd residual(const Eigen::VectorXcd& z) const;
    /// M^H r: #V, from #F.
    Eigen::VectorXcd adjoint(const Eigen::VectorXcd& r) const;

    /// Adds M^H M, the Hessian of E, to a matrix of unknowns 2 i and 2 i + 1: x and y of vertex v,
    /// i = unknown[v]; vertices with i < 0 are left out.
    void addTo(linalg::SymmetricBuilder& builder, const std::vector<int>& unknown) const;

private:
    Triangles F_;
    Eigen::MatrixX3cd rows_;
    int vertexCount_;
};

/// Solves with a factorised matrix of `addTo`, with 0 for vertices that are left out.
/// @param right  #V  @return #V. Errors: OutOfMemory.
Result<Eigen::VectorXcd> solveFree(const linalg::SparseCholesky& cholesky,
                                   const std::vector<int>& unknown, const Eigen::VectorXcd& right);

/// Minimises E with two vertices held. Solves the normal equations and then refines: the residual
/// is computed triangle by triangle, which restores the digits lost by squaring M's condition.
/// @param pins  two different vertices  @param distance  between their images, which are at the
///     origin and on the x axis
/// @return #V x 2, unit of the distance
/// Errors: FactorisationFailed, OutOfMemory, NotFinite, Cancelled. Cost: one factorisation of size
/// 2 #V - 4, and a few back-substitutions. Re-entrant.
Result<Points2> solvePinned(const ConformalEnergy& energy, std::array<int, 2> pins, double distance,
                            const Progress& progress);

/// Minimises E among maps whose boundary vertices have a given mean square, without held vertices:
/// the eigenvector of M^H M z = lambda B z of the smallest eigenvalue apart from the constants, B
/// the identity on the boundary and zero inside, [MTAD08].
/// @param boundary  its vertices  @return #V x 2, to be scaled
/// @param iterations  set to the number of steps taken
/// Errors: FactorisationFailed, OutOfMemory, NotFinite, Cancelled. Cost: one factorisation of size
/// 2 #V, one back-substitution per step: 5 to 20, up to 200 if two eigenvalues are close.
Result<Points2> solveSpectral(const ConformalEnergy& energy, const std::vector<int>& boundary,
                              int& iterations, const Progress& progress);

/// Common functions of the methods without a fixed outline.

/// Two boundary vertices far apart in space: the farthest from the outline's middle, then in turn
/// the farthest from the other until the distance stops growing. Cost: linear. Pure.
std::array<int, 2> farPairInSpace(const Piece& piece);

/// Two boundary vertices far apart along the mesh's edges: the same search with shortest edge
/// paths, in which a rolled piece is long. Cost: a few times #E log #V. Pure.
std::array<int, 2> farPairAlongEdges(const Piece& piece);

/// The result of a free-boundary method: points scaled to the 3D perimeter of the outline, and the
/// outline's angle energy. Errors: NotFinite (a collapsed or broken outline).
Result<FlatPiece> atTrueSize(const Piece& piece, const Points2& points, const Stopwatch& time);

}  // namespace toile
