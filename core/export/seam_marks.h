// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/drawing.h"

namespace toile {

/// Draws what a sewer needs to find a seam's other side: a tick at both ends of every seam, from
/// the outline into the cloth, and the seam's number and name at its middle, along the edge. Where
/// the name is longer than the edge the number stands alone. Both sides carry the same number and
/// name. Ids: `piece-<id>--seam-<number>-tick-<k>`, `piece-<id>--seam-<number>-name`; a piece sewn
/// to itself has "b" after the number of the second side.
/// @param offset  of the piece on the page, mm. Linear.
void addSeamMarks(Drawing& drawing, const PatternPiece& piece, const Eigen::Vector2d& offset);

}  // namespace toile
