// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/cut/cut_along.h"
#include "core/garment/piece.h"

namespace toile {

/// Where the parts of a piece that was cut come from.

/// @param whole   of the piece  @param cuts  one per path of `cut`
/// @param partOf  per vertex of the cut mesh: its part, -1 where it is unused
/// @return one per part  Cost: parts and runs, times the cuts that part them. Pure.
std::vector<Lineage> partLineages(const Lineage& whole, std::span<const CutId> cuts,
                                  const CutResult& cut, const std::vector<int>& partOf, int parts);

/// The origins of rim edges of a cut mesh.
class PartOrigins {
public:
    /// @param piece  that was cut; outlives this, as `cut` does
    /// @param paths  those that it was cut along, one per id
    PartOrigins(const Piece& piece, std::span<const CutId> cuts,
                const std::vector<PathPolyline>& paths, const CutResult& cut);

    /// Of the rim edges of one part. @param vertex  per vertex of the part: that of the cut mesh
    std::vector<EdgeOrigin> of(const Piece& part, const std::vector<int>& vertex) const;

private:
    /// A vertex on a rim edge of the piece: how far along, 0 to 1.
    std::optional<double> shareOn(const EdgeOrigin& edge, int vertex) const;
    const EdgeOrigin* rimAt(int vertex) const;

    const Piece& piece_;
    const CutResult& cut_;
    std::unordered_map<int, EdgeOrigin> opened_;  ///< by tail, in the cut mesh
};

}  // namespace toile
