// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "core/garment/piece.h"
#include "core/geometry/buckets.h"

namespace toile {

/// A path from loop vertex `from` to loop vertex `to` of the outline, with the piece's vertices.
struct InteriorPath {
    int from, to;  ///< indices into Piece::boundary
    std::vector<int> vertices;
    double length;  ///< mm
};

/// Shortest paths along edges through the inside of a piece: they touch the outline only at their
/// ends, and never a hole's rim. Keeps a reference to the piece. Use from one thread at a time:
/// searches share their workspace.
class InteriorPaths {
public:
    /// Cost: linear.
    explicit InteriorPaths(const Piece& piece);

    /// For each reachable target, in order: the path from the nearest source. Ties between paths
    /// are decided by index.
    /// @param sources, targets  indices into Piece::boundary
    /// @param longest           mm: longer paths are left out; the others do not depend on it
    /// Cost: O(m log m) for the m edges within `longest` of the sources, and the targets.
    std::vector<InteriorPath> find(const std::vector<int>& sources, const std::vector<int>& targets,
                                   double longest = std::numeric_limits<double>::infinity());

    /// Whether the last find() may have left out longer paths.
    bool hasLeftOut() const { return hasLeftOut_; }

private:
    void search(const std::vector<int>& sources, double longest);

    const Piece& piece_;
    std::vector<int> loopIndex_;      ///< per vertex; -1 inside
    std::vector<bool> isHoleRim_;     ///< per vertex
    geometry::Buckets<> neighbours_;  ///< per vertex: along interior edges
    // Between two searches: infinite, -1, empty.
    std::vector<double> distance_;
    std::vector<int> parent_;
    std::vector<int> reached_;
    bool hasLeftOut_ = false;
};

}  // namespace toile
