// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/document/line_facts.h"
#include "core/pattern/line_settings.h"

namespace toile {
struct Symmetry;
}  // namespace toile

namespace toile::app {

/// Edits of the settings of lines, one function each; all other settings keep their values. All are
/// pure, and linear in the settings. `facts` are those of `lines`.

/// With fair lines, which other edits need; keeps their settings.
LineSettings withFairing(LineSettings lines);

/// With these settings of the segment at `settings.place`.
LineSettings withSegment(LineSettings lines, const SegmentSettings& settings);
/// Without a length of the segment at a place.
LineSettings withoutLength(LineSettings lines, const LineStretch& place);

/// The segments that share an edit: one, the segment sewn to it, and the mirror images of both.
/// @param bothSides  false: without the sewn one
/// @param symmetry   null: edits are not mirrored
std::vector<SegmentAt> alikeSegments(const Garment& garment, const LineFacts& facts,
                                     const SegmentAt& one, bool bothSides,
                                     const Symmetry* symmetry);

/// The width of the allowance beside a segment, set or by its kind; of pieces without allowances
/// the width that it would have.
double allowanceOf(const Garment& garment, const Segment& segment, const LineSettings& lines);
/// With this allowance beside segments; none: by their kind. A width gives allowances to all
/// pieces.
LineSettings withAllowance(LineSettings lines, const LineFacts& facts,
                           const std::vector<SegmentAt>& segments, std::optional<double> width);
/// With this corner of the allowances at the start of a segment; none: automatic.
/// @param image  the segment's mirror image, if edits are mirrored; it ends at the mirrored corner
LineSettings withCorner(LineSettings lines, const LineFacts& facts, const SegmentAt& one,
                        const std::optional<SegmentAt>& image, std::optional<CornerRule> rule);

/// With free edges extended by this width, mm; none: not extended.
LineSettings withExtension(LineSettings lines, const LineFacts& facts,
                           const std::vector<SegmentAt>& segments, std::optional<double> width);

/// The width of the facing that a segment is part of; none if it has no facing.
std::optional<double> facingOf(const LineSettings& lines, const Segment& segment);
/// With segments in a facing of this width: their own or a neighbour's facing, which gets this
/// width, otherwise a new one each. No width: in no facing.
/// @param names  of new facings, one per segment
LineSettings withFacing(LineSettings lines, const LineFacts& facts,
                        const std::vector<SegmentAt>& segments, std::optional<double> width,
                        const std::vector<std::string>& names);

/// The settings of a dart. @param dart  index into Garment::seams
DartSettings dartSettings(const Garment& garment, const LineSettings& lines, int dart);
/// With this intake, mm, of a dart and its mirror image; none: as flattened.
/// @param symmetry  null: edits are not mirrored
LineSettings withIntake(LineSettings lines, const Garment& garment, int dart,
                        std::optional<double> intake, const Symmetry* symmetry);
/// With a dart pressed over this leg, and its mirror image over the mirrored leg; none: by
/// convention.
LineSettings withLay(LineSettings lines, const Garment& garment, int dart,
                     std::optional<DartLay> lay, const Symmetry* symmetry);

/// With the kink at the end of a seam trued or kept. Stores nothing if the general rule already
/// says so.
LineSettings withSeamEnd(LineSettings lines, const SeamGraph& graph, const SeamEnd& end,
                         bool trued);

/// The place of a vertex of a piece's outline; none if its line is not known.
/// @param at  index into Piece::boundary
std::optional<TurnPointSettings> turnPointAt(const Piece& piece, int at);
/// With a turn point there, or without one (`turns`).
LineSettings withTurnPoint(LineSettings lines, const TurnPointSettings& point);

}  // namespace toile::app
