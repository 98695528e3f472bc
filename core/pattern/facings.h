// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/pattern/pattern.h"

namespace toile {

/// True where most of a segment's place is part of a facing.
bool isFaced(const LineStretch& place, const Facing& facing);

/// Copies of strips along the outlines of pieces, to be cut as pieces of their own: all of a piece
/// that is within the width of a run of neighbouring segments, which the strip repeats point by
/// point, so that it can be sewn to them. Its other edges are parts of the outlines beside the run,
/// with their allowances, and the inner edge, parallel to the run, with none.
/// - Where the outline is parted, each run has its own strip; one that is a whole outline has none,
///   nor has one whose ends would meet.
/// - Holes and darts within the strip are left out; it is cut as its piece is, never as a half.
/// @param pattern  its pieces, whole
/// @return by facing and piece; without outline where no strip has room
/// Cost: none without facings; else n log n in the outlines with some. Pure.
std::vector<FacingPiece> facingsOf(const Pattern& pattern, const std::vector<Facing>& facings);

/// The outline of a strip but for the run that it is sewn to: from the run's end to its start.
Points2 innerEdge(const PatternPiece& strip);

}  // namespace toile
