// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/cut/cut_along.h"
#include "core/garment/piece.h"

namespace toile {

/// The origins of the parts of a cut piece.

/// @param whole   of the piece  @param cuts  one per path of `cut`
/// @param partOf  per vertex of the cut mesh: its part, -1 if it is unused
/// @return one per part  Cost: parts and runs, times the cuts that separate them. Pure.
std::vector<Lineage> partLineages(const Lineage& whole, std::span<const CutId> cuts,
                                  const CutResult& cut, const std::vector<int>& partOf, int parts);

/// The origins of rim edges of a cut mesh.
class PartOrigins {
public:
    /// @param piece  the cut piece; must outlive this, like `cut`
    /// @param paths  the paths of the cuts, one per id
    PartOrigins(const Piece& piece, std::span<const CutId> cuts,
                const std::vector<PathPolyline>& paths, const CutResult& cut);

    /// Of the rim edges of one part. @param vertex  index in the cut mesh, per vertex of it
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
