// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/flatten/isometric/flat_energy.h"

namespace toile::isometric {

/// The symmetric Dirichlet energy of a flattening [SS15],
///   E(Q) = sum_T A_T (|J_T|^2 + |J_T^-1|^2) / 4,
/// with A_T the triangle's area in 3D divided by the total area. It is alike in all directions.
class SymmetricDirichlet final : public FlatEnergy {
public:
    SymmetricDirichlet(const MeshArrays& mesh, const EdgeTable& table) : FlatEnergy(mesh, table) {}

    double energy(const Points2& Q) const override;
    Points2 gradient(const Points2& Q) const override;
    /// Of the four eigenvalues of a triangle only the twist's can be negative ([SGK19] section 4);
    /// it is raised to zero.
    void addHessian(const Points2& Q, const std::vector<int>& edgeOf,
                    linalg::BlockMatrix& hessian) const override;

private:
    double starEnergy(const Points2& Q, std::span<const int> star) const override;
    VertexModel vertexModel(const Points2& Q, std::span<const int> star, int v) const override;
};

}  // namespace toile::isometric
