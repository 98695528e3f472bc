// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A triangulated surface without its place in space: every triangle flat in a plane of its own.
/// Edges can be turned (flipped) within the surface, after which two triangles may share two edges
/// and an edge may end where it began. Half-edge 3 f + k starts as the one from corner k of face f
/// to corner k + 1; a flip keeps the numbers and changes what they stand for.
class FlippableSurface {
public:
    /// @param mesh  a manifold, oriented surface without degenerate triangles  Cost: linear.
    FlippableSurface(const MeshArrays& mesh, const EdgeTable& table);

    int halfedgeCount() const { return static_cast<int>(halfedges_.size()); }
    int twin(int h) const { return halfedges_[h].twin; }  ///< -1 on the boundary
    int origin(int h) const { return halfedges_[h].origin; }
    int target(int h) const { return halfedges_[next(h)].origin; }

    /// Cotangent of the angle opposite to a half-edge in its triangle. Finite.
    double oppositeCotangent(int h) const;
    /// True where the angles opposite to an interior edge sum to more than pi, by more than
    /// rounding can say: of a square's two diagonals neither wants to be the other.
    bool wantsFlip(int h) const;
    /// Replaces an edge by the other diagonal of its two triangles, laid out in a plane.
    /// @return false, and nothing is done, where that would turn a triangle over
    bool flip(int h);
    /// The other four sides of the two triangles at an interior edge.
    std::array<int, 4> sidesAround(int h) const;

private:
    struct Halfedge {
        Eigen::Vector2d vector;  ///< in its triangle's plane; the three of a triangle sum to zero
        int next;
        int twin;
        int origin;
    };

    int next(int h) const { return halfedges_[h].next; }
    int previous(int h) const { return next(next(h)); }
    void layOut(const MeshArrays& mesh, int face);

    std::vector<Halfedge> halfedges_;
};

}  // namespace toile
