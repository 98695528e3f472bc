// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/base/id.h"
#include "core/io/conventions.h"

namespace toile {

struct Piece;
/// Shared: versions of a garment have the pieces in common that an edit leaves alone.
using Pieces = std::vector<std::shared_ptr<const Piece>>;

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
    std::vector<PieceId> uncut;  ///< pieces of the division that are in it, ascending
    std::vector<CutSide> sides;  ///< of every cut that parted these, in the order of the cuts

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
std::vector<int> predecessors(const Pieces& before, const Pieces& after);

/// Where an edge of a piece's rim comes from: a stretch of a rim of the division, or one side of a
/// cut. Places are shares of that line's length, 0 to 1, so that they stay where the garment is
/// read in another unit. A rim runs with the surface on its left, from the least of its vertices by
/// the file's coordinates; on the right side of a cut from > to.
struct EdgeOrigin {
    int tail = -1, head = -1;  ///< vertices of the piece, surface on the left
    LineId line;
    CutId cut;  ///< none where the line is a rim of the division
    double from = 0, to = 0;
};

/// The line that a cut is.
LineId lineOf(CutId cut);

/// The origins of a piece as it was divided: its own rims, known by its id and by where they begin.
/// Rims that do not close, as those of a surface that is no manifold, have none.
/// @param up  of the file  @return sorted by tail  Cost: linear. Pure.
std::vector<EdgeOrigin> rimOrigins(const Piece& piece, UpAxis up);

/// The origin of the rim edge that leaves a vertex; null where it is not known.
const EdgeOrigin* originAt(const std::vector<EdgeOrigin>& origins, int tail);

}  // namespace toile
