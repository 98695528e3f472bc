// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/garment/piece.h"

namespace toile {

/// A way from loop vertex `from` to loop vertex `to` of the outline, with the piece's vertices.
struct InnerWay {
    int from, to;  ///< indices into Piece::boundary
    std::vector<int> path;
    double length;  ///< mm
};

/// Shortest ways along edges through the inside of a piece: they touch the outline only at their
/// ends, and no hole's rim. Keeps a reference to the piece.
class InnerWays {
public:
    explicit InnerWays(const Piece& piece);

    /// For each target that can be reached, in order: the way from the nearest source. Equal ways
    /// are decided by index. @param sources, targets  indices into Piece::boundary
    /// Cost: O(#E log #E).
    std::vector<InnerWay> find(const std::vector<int>& sources,
                               const std::vector<int>& targets) const;

private:
    const Piece& piece_;
    const TriMesh& halfedges_;
    std::vector<int> loopIndex_;   ///< of each vertex; -1 inside
    std::vector<bool> isHoleRim_;  ///< of each vertex
};

}  // namespace toile
