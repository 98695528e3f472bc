// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"

namespace toile {

/// Lengths of the two flat edges of a seam, mm.
struct SeamMeasure {
    double length3d[2] = {0, 0};  ///< left and right, on the garment
    double length2dLeft = 0;
    double length2dRight = 0;
    /// length2dLeft - length2dRight: the length to ease in, or gather, when sewing.
    double deltaMm = 0;
    /// Intended extra length of the left side, as a fraction of the right side's (0.1 = 10 %).
    /// Negative if the right side is longer.
    double ease = 0;
    /// length2dLeft - (1 + ease) * length2dRight: the unintended part of the difference. Zero if
    /// both outlines keep their 3D lengths; a ledger should judge this value.
    double errorMm = 0;
};

/// The intended ease of a seam: its own if set, else that of the 3D lengths, left / right - 1; zero
/// for a free edge.
double easeOf(const Seam& seam);

/// Measures a seam between two flat pieces. A part of an edge counts in proportion.
/// @param flatL, flatR  flat pieces of l and r; identical if l and r are the same piece
/// For a free edge `r` and `flatR` are ignored, and the differences are zero.
/// Cost: linear in the edges of the two outlines. Pure.
SeamMeasure measureSeam(const Seam& seam, const Piece& l, const FlatPiece& flatL, const Piece& r,
                        const FlatPiece& flatR);

/// How much longer an edge is in the pattern than in 3D, and why.
struct LengthChange {
    LengthCause cause = LengthCause::Mirroring;
    double millimetres = 0;

    bool operator==(const LengthChange&) const = default;
};

/// Smaller changes are not listed, mm.
inline constexpr double kMinLengthChange = 0.005;

/// The largest length change of an outline for each cause; empty for a method with a free outline.
/// Cost: linear. Pure.
std::vector<LengthChange> changesOf(const PieceResult& result);
/// The same for both sides of a seam, or a free edge.  Cost: linear in the outlines. Pure.
std::vector<LengthChange> changesOf(const Seam& seam, const PieceResults& results);

/// "mirroring", "length", "ease", "improving".
std::string_view name(LengthCause cause);

/// How well the two flat edges of a seam fit each other, without the intended ease.
enum class SeamFit {
    Unknown,  ///< not measured: a side is not flat, or the edge is free
    Matches,  ///< within half a millimetre, below the precision of scissors
    Nearly,   ///< within 1.6 mm, a sixteenth of an inch: tolerable when sewing
    Differs,
};

/// Bounds of |errorMm|.
inline constexpr double kMatchesMm = 0.5, kNearlyMm = 1.6;

/// The measure of a seam; nothing if a side is not flat. A free edge has one, with its length
/// alone.
/// @param seam  an index into the garment's seams  Cost: linear in the two outlines. Pure.
std::optional<SeamMeasure> measured(const Garment& garment, const PieceResults& results, int seam);

SeamFit seamFit(const Seam& seam, const std::optional<SeamMeasure>& measure);

/// The place on the other side of a seam that faces a place on one side; clamped to the other
/// side's ends. @param place  arc length, counted as the side does  @param fromRight  it is on the
/// right side. Precondition: the seam has matches.  Cost: linear in them. Pure.
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

/// Both lines of a stretch, each with the points of both. Cost: linear in the outline. Pure.
StretchLines stretchLines(const SeamSide& side, const Piece& piece, const FlatPiece& flat);

/// The whole outline of a piece as a stretch: from its first vertex once around.
SeamSide wholeOutline(const Piece& piece, int index);

/// "seam", "dart", "fold", "free".
std::string_view name(SeamKind kind);

/// Flat length of a stretch of outline as it is drawn, mm.
double flatLength(const SeamSide& side, const Piece& piece, const FlatPiece& flat);

}  // namespace toile
