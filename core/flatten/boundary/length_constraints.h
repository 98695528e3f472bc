// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/linalg/block_matrix.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Closed loops of boundary edges whose lengths are fixed: the outline of a piece, followed by the
/// rims of holes if these are fixed too. Vertices and edges are numbered through all loops; edge i
/// runs from vertex i to the next one of its loop. No vertex is in two loops. The lengths are those
/// on the surface, unless others are given. Immutable.
class EdgeLoops {
public:
    /// The outline only.
    EdgeLoops(std::vector<int> outline);
    /// @param loops  the outline first; each of at least three vertices, surface on the left
    explicit EdgeLoops(const std::vector<std::vector<int>>& loops);

    int count() const { return static_cast<int>(vertices_.size()); }
    const std::vector<int>& vertices() const { return vertices_; }
    int vertex(int i) const { return vertices_[i]; }
    int next(int i) const { return next_[i]; }
    int previous(int i) const { return previous_[i]; }
    /// The vertex at the end of edge i.
    int end(int i) const { return vertices_[next_[i]]; }

    int loopCount() const { return static_cast<int>(starts_.size()) - 1; }
    /// Number of the first vertex of a loop; for the index after the last loop: `count()`.
    int start(int loop) const { return starts_[loop]; }
    std::vector<int> loop(int index) const;
    std::vector<int> outline() const { return loop(0); }

    /// The same loops with other numbers of vertices.
    EdgeLoops renumbered(const std::vector<int>& numbers) const;

    /// The same loops with these edge lengths (unit of V; empty: those on the surface).
    EdgeLoops withLengths(Eigen::VectorXd lengths) const;
    /// The target lengths of the edges.
    Eigen::VectorXd lengths(const Points3& V) const;

    /// The same loops with the outline's vertices held: only rims move.
    EdgeLoops withOutlineHeld() const;
    bool holdsOutline() const { return holdsOutline_; }
    /// Sets the rows of held vertices to zero, in a motion or in forces of all vertices (#V x 2).
    void clearHeld(Points2& motion) const;

private:
    std::vector<int> vertices_;
    std::vector<int> next_, previous_;
    std::vector<int> starts_;
    Eigen::VectorXd lengths_;  ///< empty: those on the surface
    bool holdsOutline_ = false;
};

/// The conditions |q_(i+1) - q_i| = l_i on the boundary edges of a piece: of the outline, and of
/// rims of holes if these are fixed. Immutable; O(n) each.
class LengthConstraints {
public:
    /// @param lengths  of the loops' edges, unit of Q, positive
    LengthConstraints(EdgeLoops loops, Eigen::VectorXd lengths);

    int count() const { return loops_.count(); }
    const EdgeLoops& loops() const { return loops_; }

    /// Unit vectors along the edges, n x 2; they define the derivative A of the lengths by Q.
    Points2 directions(const Points2& Q) const;
    /// |q_(i+1) - q_i| - l_i.
    Eigen::VectorXd residual(const Points2& Q) const;
    /// A P: rate of change of the lengths when Q moves along P.
    Eigen::VectorXd along(const Points2& directions, const Points2& P) const;
    /// Adds A^T y to G (#V x 2).
    void addForces(const Points2& directions, const Eigen::VectorXd& y, Points2& G) const;
    /// Adds A^T diag(stiffness) A and, for positive multipliers (the edge pulls), the second
    /// derivative of the length times the multiplier.
    void addHessian(const Points2& Q, const Eigen::VectorXd& stiffness,
                    const Eigen::VectorXd& multipliers, linalg::BlockMatrix& hessian) const;

    /// True if the lengths are exact, up to rounding of the positions.
    bool areKept(const Points2& Q) const;

    /// Moves the boundary to the exact lengths, by the smallest motion to first order (Newton steps
    /// on the residual, one cyclic tridiagonal solve per loop; quadratic convergence). False if it
    /// fails: too far away, or a collinear loop.
    bool restore(Points2& Q) const;

private:
    /// The largest length error, relative to the error that counts as exact.
    double worstError(const Points2& Q, const Eigen::VectorXd& residual) const;

    EdgeLoops loops_;
    Eigen::VectorXd lengths_;
};

}  // namespace toile
