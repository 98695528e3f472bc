// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/garment/garment.h"
#include "core/geometry/disjoint_sets.h"
#include "core/mesh/mesh_arrays.h"

// Internal header of this folder.
namespace toile {

/// The garment with its vertices moved: the same pieces by name, id and triangles, sewn at the same
/// places of the same edges. If a move changes the length ratio of a seam's sides, the seam is
/// drawn with the ratio from before (`Seam::drawn`), so that equally long sides stay equal.
/// @param positions  per piece: one per vertex, mm; empty: the piece stays
/// Cost: linear. Pure.
Garment movedGarment(const Garment& garment, const std::vector<Points3>& positions);

}  // namespace toile

// Internal header of this folder.
namespace toile {

/// Moves of a garment's vertices that agree along seams: vertices that coincide on a seam get the
/// mean of their moves; a vertex without a counterpart gets the mean of its own move and the one
/// interpolated between the two vertices across.
class SewnMoves {
public:
    /// @param moves  per piece: one per vertex, mm; empty: the piece does not move and is not sewn
    /// Keeps a reference to the garment. Cost: linear in the outlines.
    SewnMoves(const Garment& garment, std::vector<Points3> moves);

    const std::vector<Points3>& moves() const { return moves_; }
    /// Smooths the moves: each becomes the mean of those around it, weighted by a Gaussian of this
    /// deviation, mm, but ten mean edges at most, also across seams. Cost: linear in the triangles,
    /// times (length / edge)².
    void smooth(double length);

private:
    /// A place of an outline: a vertex, or a point between two.
    struct Place {
        int piece, tail, head;
        double share;
    };

    int numberOf(int piece, int vertex) const { return first_[piece] + vertex; }
    void match();
    void even();
    double meanEdge() const;

    const Garment& garment_;
    std::vector<Points3> moves_;
    std::vector<int> first_;  ///< per piece: the number of its first vertex
    geometry::DisjointSets groups_;
    std::vector<int> sizes_;                        ///< of groups, by root
    std::vector<std::pair<Place, Place>> between_;  ///< a vertex, and the place it lies on
};

}  // namespace toile
