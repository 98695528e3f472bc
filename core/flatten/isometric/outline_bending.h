// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/flatten/boundary/edge_loops.h"
#include "core/linalg/block_matrix.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A little stiffness of the outline in its angles: sum_i weight_i (theta_i - alpha_i)^2, the
/// objective of [Wang05] eq. (9) with a weight in proportion to the edges beside the vertex. Where
/// lengths are kept but the cloth would rather be shorter, an outline without it buckles into a
/// zigzag of single edges, which nobody can sew. A smooth change of the outline's shape costs next
/// to nothing: its change per vertex goes to zero with the edges' length. The same for rims of
/// holes. Immutable; O(n) each.
class OutlineBending {
public:
    /// @param angles   alpha, radians  @param lengths  of the edges  @param stiffness  sum of all
    ///                 weights: the cost of one radian at every vertex
    OutlineBending(EdgeLoops loops, Eigen::VectorXd angles, const Eigen::VectorXd& lengths,
                   double stiffness);

    double energy(const Points2& Q) const;
    void addGradient(const Points2& Q, Points2& g) const;
    /// Gauss-Newton: positive semidefinite. Precondition: the matrix has the edges between each
    /// vertex of the outline, the next and the one after that.
    void addHessian(const Points2& Q, BlockMatrix& hessian) const;

private:
    /// 2 sin((theta - alpha) / 2) at one vertex, which is theta - alpha where small and has no jump
    /// at a full turn, and its derivatives by the vertex before, the vertex itself and the next.
    struct Turn {
        int vertex[3];
        double excess;
        Eigen::RowVector2d slope[3];
    };

    Turn turnAt(const Points2& Q, int i) const;

    EdgeLoops loops_;
    Eigen::VectorXd angles_;
    Eigen::VectorXd weights_;
};

}  // namespace toile
