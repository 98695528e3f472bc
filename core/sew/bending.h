// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "core/garment/fabric_stiffness.h"
#include "core/sew/cloth.h"
#include "core/sew/space_matrix.h"

namespace toile::sew {

/// Bending energy of cloth that is flat at rest: the quadratic one of [BWHGZ06], a sum over the
/// inner edges of each piece,
///   W = sum_e B / (2 (A0 + A1)) |sum_i K_i x_i|²,
/// with A0, A1 the two triangles' areas at rest and K_i from the cotangents of their angles; for
/// small angles |sum K_i x_i| is the edge's length times the angle between the triangles. [BWHGZ06]
/// has an additional factor of 3; here a cylinder, the usual bend of cloth, costs B / (2 R²) per
/// area. For cloth without strain. Seams are hinges without resistance. N, mm. Immutable; linear
/// cost.
class Bending {
public:
    Bending(const Cloth& cloth, const PieceStiffness& stiffness);

    bool empty() const { return hinges_.empty(); }
    double energy(const Points3& X) const;
    void addGradient(const Points3& X, Points3& g) const;
    /// Positive semidefinite, independent of positions.
    void addHessian(SpaceMatrix& H) const;
    void addPairs(std::vector<std::pair<int, int>>& pairs) const;

private:
    struct Hinge {
        std::array<int, 4> vertex;  ///< the edge's ends, and the two corners across from it
        std::array<double, 4> weight;
        double stiffness;  ///< B / (A0 + A1), N/mm

        Eigen::RowVector3d bend(const Points3& X) const;
    };

    std::vector<Hinge> hinges_;  ///< of pieces with B above 0
};

}  // namespace toile::sew
