// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/capped_outline.h"

namespace toile {

/// By how much a segment is drawn out, mm: only free edges are, and their seams stay as they are.
double extensionOf(const PatternSegment& segment);

/// The line with its extensions: free edges drawn out parallel, as button stands and turn-ups are.
/// The lines that such an edge meets run straight on to its new place, or go there as its corner
/// says (`joinAllowances`, with extensions for widths).
/// @param capped  of `cappedOutline`, of this piece
/// @return the same where nothing is drawn out; else a line as `cuttingLine` gives it, in which
///         what is drawn out belongs to its segment, and the way there to the neighbour's
/// Cost: that of `cuttingLine`, and points drawn out times points. Pure.
CappedOutline extendedOutline(const PatternPiece& piece, CappedOutline capped);

/// What a person sees of extensions: the finished edges, from where they leave the outline to where
/// they come back; of a whole outline that is drawn out the first point once more at the end.
/// Cost: as above. Pure.
std::vector<Points2> extensionEdges(const PatternPiece& piece, const CappedOutline& extended);

}  // namespace toile
