// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/linalg/sparse_cholesky.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The conformal energy with a free boundary, E(z) = 1/2 sum over triangles |(M z)_T|^2, where
/// z = x + i y are the planar points as complex numbers. Row T of M holds e_k / (2 sqrt(A)) at the
/// triangle's k-th corner, e_k the edge opposite to it in the triangle's own plane, A its area.
/// That is the least squares form of [LPRM02]; summed up it is the Dirichlet energy minus
/// the signed area, [DMA02]'s natural boundary and [MTAD08]'s L_C. Kept by triangles, because M z
/// can be had to full precision where a sum over the edges cancels.
class ConformalEnergy {
public:
    /// Triangles as they are in 3D. Precondition: none degenerate.
    explicit ConformalEnergy(const MeshArrays& mesh);

    /// Triangles of the given corner angles (#F x 3, radians, in (0, pi)), whatever their sizes: a
    /// row is the same for similar triangles.
    ConformalEnergy(const Triangles& F, const Eigen::MatrixX3d& angles, int vertexCount);

    int vertexCount() const { return vertexCount_; }

    /// M z: #F, from #V.
    Eigen::VectorXcd residual(const Eigen::VectorXcd& z) const;
    /// M^H r: #V, from #F.
    Eigen::VectorXcd adjoint(const Eigen::VectorXcd& r) const;

    /// Adds M^H M, the Hessian of E, to a matrix of unknowns 2 i and 2 i + 1: x and y of vertex v,
    /// i = unknown[v]; vertices with i < 0 are left out.
    void addTo(SymmetricBuilder& builder, const std::vector<int>& unknown) const;

private:
    Triangles F_;
    Eigen::MatrixX3cd rows_;
    int vertexCount_;
};

/// Least E with two vertices held. Solved by its normal equations and then refined: the residual is
/// taken triangle by triangle, which mends the digits that squaring M's condition costs.
/// @param pins  two different vertices  @param distance  between their images, at the origin and on
///     the x axis
/// @return #V x 2, unit of the distance
/// Errors: FactorisationFailed, OutOfMemory, NotFinite, Cancelled. Cost: one factorisation of size
/// 2 #V - 4, and a few back-substitutions. Re-entrant.
Result<Points2> solvePinned(const ConformalEnergy& energy, std::array<int, 2> pins, double distance,
                            const Progress& progress);

/// Least E among maps whose boundary vertices have a given mean square, no vertex held: the
/// eigenvector of M^H M z = lambda B z of the least eigenvalue but for the constants, B the
/// identity on the boundary and zero inside, [MTAD08].
/// @param boundary  its vertices  @return #V x 2, to be scaled  @param iterations  set to the
/// number
///     of steps taken
/// Errors: FactorisationFailed, OutOfMemory, NotFinite, Cancelled. Cost: one factorisation of size
/// 2 #V, one back-substitution per step: 5 to 20, up to 200 where two eigenvalues are close.
Result<Points2> solveSpectral(const ConformalEnergy& energy, const std::vector<int>& boundary,
                              int& iterations, const Progress& progress);

}  // namespace toile
