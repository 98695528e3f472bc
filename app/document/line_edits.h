// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/document/line_facts.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"
#include "core/pattern/pattern.h"

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

/// With free edges of this kind; none: as found.
LineSettings withEdgeKind(LineSettings lines, const LineFacts& facts,
                          const std::vector<SegmentAt>& segments, std::optional<EdgeKind> kind);

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

/// Edits of internal lines. Points are in the coordinates of the pieces, mm.

using ClothPoints = std::vector<Eigen::Vector3d>;

/// Adds a line through these points, one or more, at the end of the list.
LineSettings withInternalLine(LineSettings lines, const Garment& garment, std::string name,
                              ClothPoints points, bool closed);
/// An index past the lines changes nothing.
LineSettings withoutInternalLine(LineSettings lines, std::size_t index);
/// Moves one of its points; indices past the end change nothing.
LineSettings withInternalPointMoved(LineSettings lines, const Garment& garment, std::size_t index,
                                    std::size_t point, const Eigen::Vector3d& to);

/// The mirror image of a line on the counterpart of its piece, or on its other half
/// (`mirroredCut`); none if it has none, or if it is the line itself.
std::optional<ClothPoints> mirroredInternalLine(const Garment& garment, const PieceResults& results,
                                                const Symmetry& symmetry, const ClothPoints& points,
                                                bool closed);

/// The line that was drawn as the mirror image of another: it has as many points, none farther than
/// kSameImage from the image. None if there is none.
std::optional<std::size_t> imageOfInternalLine(const LineSettings& lines, const Garment& garment,
                                               const PieceResults& results,
                                               const Symmetry& symmetry, std::size_t index);
inline constexpr double kSameImage = 2;  ///< mm

/// Makes one line the mirror image of another, if that has one.
LineSettings withInternalLineAsImage(LineSettings lines, const Garment& garment,
                                     const PieceResults& results, const Symmetry& symmetry,
                                     std::size_t of, std::size_t image);

/// Edits of notches. An edit applies to both sides of the seam, and to the seam that mirrors it.
/// Each costs the outlines of the garment.

/// A notch on a seam, whichever side it is shown on.
struct NotchAt {
    int seam = -1;     ///< index into Garment::seams
    double share = 0;  ///< of the seam's length, from its start

    bool operator==(const NotchAt&) const = default;
};

/// The pattern's notches, each once, by seam and share.
struct SeamNotch : NotchAt {
    NotchReason reason = NotchReason::Balance;
};
std::vector<SeamNotch> notchesOf(const Pattern& pattern);

/// Adds a notch; in lines without notches all automatic ones are added, too.
LineSettings withNotch(LineSettings lines, const Garment& garment, const NotchAt& at);
/// Removes a notch: deletes one that the user placed, and suppresses an automatic one.
/// @param symmetry  mirrors notches; may be null
LineSettings withoutNotch(LineSettings lines, const Garment& garment, const SeamNotch& notch,
                          const Symmetry* symmetry);
/// Moves a notch to another share of its seam.
LineSettings withNotchMoved(LineSettings lines, const Garment& garment, const SeamNotch& notch,
                            double share, const Symmetry* symmetry);

}  // namespace toile::app
