// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/pattern/pattern.h"

namespace toile {

/// True if most of a segment is part of a facing.
bool isFaced(const LineStretch& place, const Facing& facing);

/// Copies of strips along the outlines of pieces, to be cut as separate pieces: the area of a piece
/// within the width of a run of neighbouring segments. The strip repeats the run point by point, so
/// that it can be sewn to it. Its other edges are parts of the outline beside the run, with their
/// allowances, and the inner edge, parallel to the run, without allowance.
/// - If the run is interrupted, each part has its own strip. A run around a whole outline has none,
///   nor has one whose ends would meet.
/// - Holes and darts within the strip are left out; it is cut like its piece, never as a half.
/// @param pattern  with whole pieces
/// @return by facing and piece; without outline if a strip has no room
/// Cost: none without facings; else n log n in the outlines that have some. Pure.
std::vector<FacingPiece> facingsOf(const Pattern& pattern, const std::vector<Facing>& facings);

/// The outline of a strip without the run that it is sewn to: from the run's end to its start.
Points2 innerEdge(const PatternPiece& strip);

}  // namespace toile
