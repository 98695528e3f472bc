// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/pattern/darts.h"
#include "core/pattern/pattern.h"

namespace toile {

/// From point `first` of a capped outline to the start of the next stretch: a segment of the piece
/// or a part of it, with the caps laid over it.
struct CappedStretch {
    int first = 0;
    int segment = -1;  ///< index into `PatternPiece::segments`; -1: none
};

/// The outline with dart caps in place of dart legs: the base line of the seam allowances, because
/// the cloth between the legs stays.
///
/// `first` is that of an `AllowanceStretch`: to add allowances, give each stretch the width of its
/// segment and the rule of the corner where that starts, and pass them to `cuttingLine`. Segments
/// on legs under a cap do not occur; those of a dart without cap do, as edges of the piece. A cap
/// belongs to the segment beyond the leg over which its dart is laid, because it lies on that
/// segment when sewn. So the allowance beside the cap, folded with it, ends where the segment's own
/// does, even if the widths before and after the dart differ. A segment that is divided by a dart
/// occurs twice.
struct CappedOutline {
    Points2 line;  ///< closed, anti-clockwise, first point not repeated; may start at another point
    std::vector<CappedStretch> stretches;  ///< sorted by `first`; the last passes the first point
};

/// @param darts  of `findDarts`, of this piece; darts without cap stay unchanged
/// Cost: linear in the outline, plus darts times segments. Pure.
CappedOutline cappedOutline(const PatternPiece& piece, const std::vector<PieceDart>& darts);

}  // namespace toile
