// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/base/id.h"

namespace toile {

/// On which side of a cut a part of a piece lies that the cut parted.
struct CutSide {
    CutId cut;
    /// 1 on the left of the cut's direction, -1 on its right; 2, -2 and so on for further parts on
    /// the same side, in the order in which the cut meets them.
    int side = 0;

    bool operator==(const CutSide&) const = default;
};

/// Where a piece comes from. Written down where pieces are divided, joined and cut.
struct Lineage {
    std::vector<PieceId> wholes;  ///< pieces of the division that are in it, ascending
    std::vector<CutSide> sides;   ///< of every cut that parted these, in the order of the cuts

    bool operator==(const Lineage&) const = default;
};

/// The id of what a file's division gave stays with a piece that was neither joined to another nor
/// parted; else it follows from the lineage. Pure.
PieceId idOf(const Lineage& lineage);

/// The answer to "which piece was this before?", for everything that one version of a garment hands
/// on to the next: the one with the same id, else of those that share a piece of the division the
/// one that lies on other sides of the fewest cuts, and on the same of most; of equals the larger.
/// @param before  with ids; null ones are passed by
/// @return per piece of `after`: index into `before`, or -1. Cost: n log n; of a piece that a cut
/// has parted otherwise now, all its parts before times its parts after. Pure.
std::vector<int> predecessors(const std::vector<std::shared_ptr<const Piece>>& before,
                              const std::vector<std::shared_ptr<const Piece>>& after);

}  // namespace toile
