// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"
#include "core/pattern/pattern.h"
#include "core/pattern/piece_grain.h"

namespace toile {

/// Lines drawn by the user within the cloth (`InternalLine`), placed on the present pieces.

/// A point of an internal line farther from every piece than this part of the garment's diagonal is
/// not drawn, nor are its connections.
inline constexpr double kFarFromCloth = 0.02;

/// A stretch of an internal line on one piece, or a drill point.
struct InternalRun {
    int line = -1;   ///< index into the lines
    int piece = -1;  ///< of the garment
    bool closed = false;
    /// On the mesh of the piece; a drill point has one point, a closed line repeats its first point
    /// at the end. Neighbours lie in one triangle.
    std::vector<SurfacePoint> way{};
};

/// Puts every line onto the pieces as they are cut now. Its points go to the nearest surface of the
/// uncut pieces; if several are equally near, to the one nearest to all points of the line. Two
/// neighbouring points on one flat piece are joined straight in the plane. If that path would leave
/// the cloth, or cuts separate the points, it is the shortest path on the uncut piece
/// (`geodesicPath`), divided where that piece is cut: no length is lost. Points of pieces that were
/// never connected are not joined.
/// @param results  one per piece, as drawn; null, or of another piece: not flat
/// @return by line, each from start to end; nothing for points that are not finite
/// Cost: nothing without lines; else linear in the pieces, a path search for each pair of points
/// that is not joined straight, and linear in the faces for each that is. Pure.
std::vector<InternalRun> findInternalRuns(const Garment& garment, const PieceResults& results,
                                          const std::vector<InternalLine>& lines);

/// The part of a line or drill point to the left of a prolonged chord, as on a half pattern;
/// without `way`. Parts of a closed line are open. Pure.
std::vector<PieceInternal> leftPart(const PieceInternal& internal, const Chord& chord);

/// The same for open lines.
std::vector<Points2> leftParts(const std::vector<Points2>& lines, const Chord& chord);

/// Whether it is a drill point.
inline bool isDrillPoint(const PieceInternal& internal) {
    return internal.points.rows() == 1;
}

/// Its drawing in flat coordinates: the line, back to its first point if it is closed; for a drill
/// point a closed circle as for darts (`drillCircle`) and two strokes across it.
std::vector<Points2> drawnLines(const PieceInternal& internal);

}  // namespace toile
