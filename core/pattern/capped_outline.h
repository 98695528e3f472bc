// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/pattern/darts.h"
#include "core/pattern/pattern.h"

namespace toile {

/// From point `first` of a capped outline to where the next stretch begins: a segment of the piece
/// or a part of it, and the caps that are laid over it.
struct CappedStretch {
    int first = 0;
    int segment = -1;  ///< index into `PatternPiece::segments`; -1: it has none
};

/// The outline with the cap of each dart in place of its legs: the line that seam allowances are
/// laid around, as the cloth between the legs stays.
///
/// `first` is that of an `AllowanceStretch`: who lays allowances takes the stretches one by one,
/// each with the width of its segment and the rule of the corner in which that begins, and hands
/// them to `cuttingLine`. Segments on legs under a cap do not occur; those of a dart without cap
/// do, as edges of the piece. A cap belongs to the segment beyond the leg that its dart is laid
/// over, since it lies on that when sewn; so the allowance beside the cap, folded with it, ends
/// where that segment's own does, also where the widths before and after the dart differ. A segment
/// that is parted by a dart occurs twice.
struct CappedOutline {
    Points2 line;  ///< closed, anti-clockwise, first point not repeated; its own first point
    std::vector<CappedStretch> stretches;  ///< by `first`; the last runs over the first point
};

/// @param darts  of `findDarts`, of this piece; those without cap are left as they are
/// Cost: outline, and darts times segments. Pure.
CappedOutline cappedOutline(const PatternPiece& piece, const std::vector<PieceDart>& darts);

}  // namespace toile
