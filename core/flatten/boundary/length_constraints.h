// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/flatten/boundary/edge_loops.h"
#include "core/linalg/block_matrix.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The conditions |q_(i+1) - q_i| = l_i on the boundary edges of a piece: those of the outline, and
/// of rims of holes where these count. Immutable; O(n) each.
class LengthConstraints {
public:
    /// @param lengths  of the loops' edges, unit of Q, positive
    LengthConstraints(EdgeLoops loops, Eigen::VectorXd lengths);

    int count() const { return loops_.count(); }
    const EdgeLoops& loops() const { return loops_; }

    /// Unit vectors along the edges, n x 2: with them the derivative A of the lengths by Q.
    Points2 directions(const Points2& Q) const;
    /// |q_(i+1) - q_i| - l_i.
    Eigen::VectorXd residual(const Points2& Q) const;
    /// A P: how fast the lengths change when Q moves along P.
    Eigen::VectorXd along(const Points2& directions, const Points2& P) const;
    /// Adds A^T y to G (#V x 2).
    void addForces(const Points2& directions, const Eigen::VectorXd& y, Points2& G) const;
    /// Adds A^T diag(stiffness) A and, where a multiplier is positive (the edge pulls), the second
    /// derivative of its length times the multiplier.
    void addHessian(const Points2& Q, const Eigen::VectorXd& stiffness,
                    const Eigen::VectorXd& multipliers, BlockMatrix& hessian) const;

    /// True where the lengths are exact, rounding of the positions aside.
    bool areKept(const Points2& Q) const;

    /// Moves the boundary to the exact lengths, by the least motion to first order (Newton steps
    /// on the residual, one cyclic tridiagonal solve per loop; quadratic). False where it does
    /// not arrive: too far away, or a loop lies in one line.
    bool restore(Points2& Q) const;

private:
    /// The largest error of a length, in parts of what counts as none.
    double worstError(const Points2& Q, const Eigen::VectorXd& residual) const;

    EdgeLoops loops_;
    Eigen::VectorXd lengths_;
};

}  // namespace toile
