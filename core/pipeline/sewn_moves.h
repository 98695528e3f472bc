// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/garment/garment.h"
#include "core/geometry/disjoint_sets.h"
#include "core/mesh/mesh_arrays.h"

// For the sources of this folder only.
namespace toile {

/// Moves of a garment's vertices that are the same where pieces are sewn to each other: vertices
/// that lie on each other along seams get the mean of their moves, and one that has no vertex
/// across from it the mean of its own and of that between the two across.
class SewnMoves {
public:
    /// @param moves  per piece: one per vertex, mm; none: it has none and is sewn to nothing
    /// Keeps a reference to the garment. Cost: linear in the outlines.
    SewnMoves(const Garment& garment, std::vector<Points3> moves);

    const std::vector<Points3>& moves() const { return moves_; }
    /// Without what is finer than a length: each the mean of those about it, weighted as by a bell
    /// curve of this deviation, mm, but of ten mean edges at most, over seams too. Cost: linear in
    /// the triangles, times (length / edge)².
    void smooth(double length);

private:
    /// A place of an outline: a vertex, or between two.
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
    std::vector<std::pair<Place, Place>> between_;  ///< a vertex, and what it lies on
};

}  // namespace toile
