// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/piece_allowance.h"

namespace toile {

/// Width by which a segment is extended, mm; only free edges are, and their seams stay as they are.
double extensionOf(const PatternSegment& segment);

/// The line with its extensions: free edges moved outwards in parallel, for button stands and
/// turn-ups. The lines that meet such an edge continue straight to its new place, or follow its
/// corner rule (`joinAllowances`, with extensions as widths).
/// @param capped  of `cappedOutline`, of this piece
/// @return the same line if nothing is extended; else a line as of `cuttingLine`, in which the
///         extension belongs to its segment, and the way to it to the neighbouring segment
/// Cost: that of `cuttingLine`, plus extended points times points. Pure.
CappedOutline extendedOutline(const PatternPiece& piece, CappedOutline capped);

/// The visible edges of extensions: the finished edges between leaving and rejoining the outline;
/// for an outline that is extended all around, the first point is repeated at the end.
/// Cost: as above. Pure.
std::vector<Points2> extensionEdges(const PatternPiece& piece, const CappedOutline& extended);

}  // namespace toile
