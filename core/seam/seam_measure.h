// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"

namespace toile {

/// What the sewer gets: how long the two flat edges are. Lengths in mm.
struct SeamMeasure {
    double length3d[2] = {0, 0};  ///< left and right, on the garment
    double length2dLeft = 0;
    double length2dRight = 0;
    /// length2dLeft - length2dRight: what one must ease in, or gather, when sewing the pattern.
    double deltaMm = 0;
    /// How much longer the left side is meant to be: a part of the right side's length (0.1 = 10
    /// %). Negative where the right side is the longer one.
    double ease = 0;
    /// length2dLeft - (1 + ease) * length2dRight: the part of the difference that nobody wants.
    /// Zero where both outlines keep their 3D lengths; this is what a ledger should judge.
    double errorMm = 0;
};

/// The intended ease of a seam: its own, or where it states none, that of the 3D lengths, left /
/// right - 1; zero for a free edge.
double easeOf(const Seam& seam);

/// Measures a seam between two flat pieces. A part of an edge counts in proportion.
/// @param flatL, flatR  of l and r; the same where these are one
/// For a free edge `r` and `flatR` are not looked at, and the differences are zero.
/// Cost: linear in the edges of the two outlines. Pure.
SeamMeasure measureSeam(const Seam& seam, const Piece& l, const FlatPiece& flatL, const Piece& r,
                        const FlatPiece& flatR);

/// By how much something is longer in the pattern than in 3D, and why.
struct LengthChange {
    LengthCause cause = LengthCause::Mirroring;
    double millimetres = 0;

    bool operator==(const LengthChange&) const = default;
};

/// Smaller changes are not listed, mm.
inline constexpr double kMinLengthChange = 0.005;

/// The largest change of an outline's lengths for each cause; none of a method with a free outline.
/// Linear. Pure.
std::vector<LengthChange> changesOf(const PieceResult& result);
/// Likewise of the two sides of a seam, or of a free edge.  Cost: linear in the outlines. Pure.
std::vector<LengthChange> changesOf(const Seam& seam, const PieceResults& results);

/// "mirroring", "length", "ease", "improving".
std::string_view name(LengthCause cause);

/// How well the two flat edges of a seam fit each other, the intended ease taken out.
enum class SeamFit {
    Unknown,  ///< not measured: a side is not flat, or the edge is free
    Matches,  ///< to within half a millimetre, less than scissors can tell
    Nearly,   ///< to within 1.6 mm, a sixteenth of an inch: what sewing forgives
    Differs,
};

/// Bounds of |errorMm|.
inline constexpr double kMatchesMm = 0.5, kNearlyMm = 1.6;

/// The measure of a seam; none where a side is not flat yet, or cannot be. A free edge has one,
/// with its length alone.
/// @param seam  an index into the garment's seams  Cost: linear in the two outlines. Pure.
std::optional<SeamMeasure> measured(const Garment& garment, const PieceResults& results, int seam);

SeamFit seamFit(const Seam& seam, const std::optional<SeamMeasure>& measure);

/// Where a place on one side of a seam comes to lie on the other; one beyond the side at its nearer
/// end. @param place  arc length, counted as the side does  @param fromRight  it is on the right
/// side. Precondition: the seam has matches.  Cost: linear in them. Pure.
double placeAcross(const Seam& seam, double place, bool fromRight);

/// The vertices of the loop that a side runs along, surface on its left.
const std::vector<int>& loopOf(const SeamSide& side, const Piece& piece);

/// Flat stretch of outline as a polyline, mm, in the side's direction: its two ends and the points
/// of the outline, as it is drawn, between them. Cost: linear in the outline. Pure.
Points2 flatLine(const SeamSide& side, const Piece& piece, const FlatPiece& flat);
/// The same stretch on the garment: a polyline in space, mm, as long as the side. Pure.
Points3 spaceLine(const SeamSide& side, const Piece& piece);

/// A stretch of outline on the garment and in the pattern, point by point.
struct StretchLines {
    Points3 space;
    Points2 flat;
};

/// Both lines of a stretch, with the points that either needs. Cost: linear in the outline. Pure.
StretchLines stretchLines(const SeamSide& side, const Piece& piece, const FlatPiece& flat);

/// The whole outline of a piece as a stretch: from its first vertex once around.
SeamSide wholeOutline(const Piece& piece, int index);

/// "seam", "dart", "fold", "free".
std::string_view name(SeamKind kind);

/// Flat length of a stretch of outline as it is drawn, mm.
double flatLength(const SeamSide& side, const Piece& piece, const FlatPiece& flat);

}  // namespace toile
