// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/garment/garment.h"
#include "core/pattern/segments.h"
#include "core/pattern/trueing.h"

namespace toile::app {

/// What a person decides of lines, one edit each; the rest of the settings stays. All pure, linear
/// in the settings.

/// With fair lines, as they are or as usual: what follows needs them.
LineSettings withFairing(LineSettings lines);

/// With this said of a segment, in place of what was said of it before.
/// @param said  `place` as the segment has it
LineSettings withSegment(LineSettings lines, const SegmentSettings& said);
/// With no length said of the segment at a place.
LineSettings withoutLength(LineSettings lines, const LineStretch& place);

/// With the kink at a seam's end taken out or left there; what the general rule says already is
/// not said once more.
LineSettings withSeamEnd(LineSettings lines, const SeamGraph& graph, const SeamEnd& end,
                         bool trued);

/// The place of a vertex of a piece's outline; none where it is not known what line that is of.
/// @param at  index into Piece::boundary
std::optional<TurnPointSettings> turnPointAt(const Piece& piece, int at);
/// With a turn point there, or with none (`turns`).
LineSettings withTurnPoint(LineSettings lines, const TurnPointSettings& point);

}  // namespace toile::app
