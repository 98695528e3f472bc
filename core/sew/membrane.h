// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/garment/fabric_stiffness.h"
#include "core/geometry/buckets.h"
#include "core/sew/cloth.h"
#include "core/sew/space_matrix.h"

namespace toile::sew {

/// Energy of cloth under stretch, compression and shear: St. Venant and Kirchhoff's, on linear
/// triangles ([BW98] has the triangles, [VMF09] the strain). With the deformation
/// F of a triangle and Green's strain E = (F^T F - 1) / 2, weft 1, warp 2:
///   W = sum_T A_T (C11 E11² / 2 + C22 E22² / 2 + C12 E11 E22 + 2 G E12²).
/// It does not depend on the side of the plane that a triangle lies on. Forces in N, lengths in mm,
/// energy in N·mm. Immutable; keeps a reference to the cloth; linear cost.
class Membrane {
public:
    Membrane(const Cloth& cloth, const PieceStiffness& stiffness);

    double energy(const Points3& X) const;
    /// Adds the derivative with respect to each coordinate: minus the vertex forces, N.
    void addGradient(const Points3& X, Points3& g) const;
    /// Adds the second derivative, N/mm, made positive semidefinite per triangle: the part from the
    /// change of strain already is; of the part from the stress only tension is used. Results do
    /// not depend on the number of threads.
    void addHessian(const Points3& X, SpaceMatrix& H, int threads = 1) const;
    /// Adds per vertex the magnitudes of its triangles' forces, N, which cancel there.
    void addForceSizes(const Points3& X, Eigen::VectorXd& sizes) const;
    /// Adds the pairs of vertices that act on each other.
    void addPairs(std::vector<std::pair<int, int>>& pairs) const;

private:
    /// Second Piola-Kirchhoff stress in a triangle, N/mm.
    Eigen::Matrix2d stress(Eigen::Index f, const Eigen::Matrix2d& green) const;
    const Eigen::Matrix3d& moduliOf(Eigen::Index f) const { return moduli_[cloth_.pieceOf[f]]; }
    template <class Add>
    void forEachForce(const Points3& X, Add add) const;

    const Cloth& cloth_;
    std::vector<RestShape> rest_;
    geometry::Buckets<> corners_;          ///< 3 f + k: the triangles' corners at each vertex
    std::vector<Eigen::Matrix3d> moduli_;  ///< per piece: from (E11, E22, 2 E12), N/mm
};

}  // namespace toile::sew
