// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/flatten/boundary/length_constraints.h"
#include "core/linalg/block_matrix.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::isometric {

/// A little angular stiffness of the outline: sum_i weight_i (theta_i - alpha_i)^2, the objective
/// of [Wang05] eq. (9) with weights proportional to the edges at the vertex. If lengths are kept
/// but the cloth would rather be shorter, an outline without it buckles into a zigzag of single
/// edges, which cannot be sewn. A smooth change of the outline's shape costs almost nothing: its
/// change per vertex goes to zero with the edges' length. The same applies to rims of holes.
/// Immutable; O(n) each.
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
    void addHessian(const Points2& Q, linalg::BlockMatrix& hessian) const;

private:
    /// 2 sin((theta - alpha) / 2) at one vertex, which is theta - alpha if small and has no jump
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

/// Keeps an outline from crossing itself, as [SS15] section 4 does: each boundary vertex that comes
/// nearer than `radius` to a boundary edge it does not belong to adds
///   B = weight (radius / d - 1)^2
/// to the energy, d its distance from the edge. Infinite at contact, zero beyond the radius, once
/// differentiable. The radius is a tenth of the shortest edge concerned, so that two sides of a
/// slit come to lie side by side. Immutable. Cost: O(n log n) per call unless the outline is
/// coiled.
class OutlineBarrier {
public:
    /// @param boundary  loop of vertices  @param lengths  of its edges, unit of Q
    OutlineBarrier(std::vector<int> boundary, const Eigen::VectorXd& lengths);

    /// Per boundary vertex: contact distance from an edge as long as its own.
    Eigen::VectorXd radius() const;

    /// A vertex near an edge.
    struct Contact {
        int vertex, from, to;  ///< mesh vertices
        double radius, weight;
        double distance;
        double place;             ///< of the nearest point along the edge, in [0, 1]
        Eigen::RowVector2d away;  ///< unit vector from the nearest point to the vertex
    };

    std::vector<Contact> contacts(const Points2& Q) const;

    static double energy(const std::vector<Contact>& contacts);
    static void addGradient(const std::vector<Contact>& contacts, Points2& g);
    /// Gauss-Newton: positive semidefinite. Precondition: the matrix has all edges between the
    /// three vertices of every contact.
    static void addHessian(const std::vector<Contact>& contacts, linalg::BlockMatrix& hessian);

    /// Adds forces that, against the stiffness of `addHessian`, restore to first order the
    /// distances that a step should leave, at least a share of the old ones. Sliding along an edge
    /// that turns leaves less. @return whether any is too short
    static bool addOpeningForces(const std::vector<Contact>& contacts, const Points2& step,
                                 const Points2& moved, Points2& forces);

    /// The largest step up to `limit` along P before a vertex meets an edge.
    double largestStep(const Points2& Q, const Points2& P, double limit) const;

private:
    std::vector<int> boundary_;
    Eigen::VectorXd radius_;  ///< of each edge
    Eigen::VectorXd weight_;  ///< of each vertex
};

}  // namespace toile::isometric
