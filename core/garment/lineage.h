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

/// The side of a cut on which a part of the divided piece lies.
struct CutSide {
    CutId cut;
    /// 1 on the left of the cut's direction, -1 on its right; 2, -2 and so on for further parts on
    /// the same side, in the order along the cut.
    int side = 0;

    bool operator==(const CutSide&) const = default;
};

/// The origin of a piece. Recorded when pieces are divided, joined and cut.
struct Lineage {
    std::vector<PieceId> uncut;  ///< pieces of the division that it contains, ascending
    std::vector<CutSide> sides;  ///< of every cut that separated these, in the order of the cuts

    bool operator==(const Lineage&) const = default;
};

/// A piece that was neither joined nor divided keeps its id from the file's division; otherwise the
/// id is derived from the lineage. Pure.
PieceId idOf(const Lineage& lineage);

/// The answer to "which piece was this before?", for everything that one version of a garment hands
/// on to the next: the one with the same id, else of those that share a piece of the division the
/// one that lies on other sides of the fewest cuts, and on the same of most; of equals the larger.
/// @param before  with ids; null ones are passed by
/// @return per piece of `after`: index into `before`, or -1. Cost: n log n; of a piece that a cut
/// has parted otherwise now, all its parts before times its parts after. Pure.
std::vector<int> predecessors(const Pieces& before, const Pieces& after);

/// The origin of an edge of a piece's rim: a stretch of a rim of the division, or one side of a
/// cut. Positions are shares of that line's length, 0 to 1, so that they do not depend on the
/// garment's unit. A rim runs with the surface on its left, starting at the smallest of its
/// vertices by the file's coordinates; on the right side of a cut from > to.
struct EdgeOrigin {
    int tail = -1, head = -1;  ///< vertices of the piece, surface on the left
    LineId line;
    CutId cut;  ///< none if the line is a rim of the division
    double from = 0, to = 0;
};

/// The line of a cut.
LineId lineOf(CutId cut);

/// The origins of a piece of the division: its own rims, identified by its id and their start. Rims
/// that do not close, like those of non-manifold surfaces, have none.
/// @param up  of the file  @return sorted by tail  Cost: linear. Pure.
std::vector<EdgeOrigin> rimOrigins(const Piece& piece, UpAxis up);

/// The origin of the rim edge that starts at a vertex; null if it is unknown.
const EdgeOrigin* originAt(const std::vector<EdgeOrigin>& origins, int tail);

}  // namespace toile
