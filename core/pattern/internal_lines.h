// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/pattern/added_settings.h"
#include "core/pattern/grain_line.h"
#include "core/pattern/pattern.h"

namespace toile {

/// What a person has drawn within the cloth (`InternalLine`), on the cloth as it lies now.

/// A point of an internal line farther from every piece than this part of the garment's diagonal is
/// drawn nowhere, and what it would be joined by neither.
inline constexpr double kFarFromCloth = 0.02;

/// A stretch of an internal line on one piece, or a drill point.
struct InternalRun {
    int line = -1;   ///< index into the lines
    int piece = -1;  ///< of the garment
    bool closed = false;
    /// On the mesh of the piece; one point of a drill point, the first once more at the end of a
    /// closed line. Neighbours lie in one triangle.
    std::vector<SurfacePoint> way{};
};

/// Puts every line onto the pieces as they are cut now. Its points go to the nearest surface of the
/// pieces before they were cut; where several are as near, to that which is nearest to all of them.
/// Two neighbouring points on one flat piece are joined straight in the plane. Where that way would
/// leave the cloth, or cuts part the points, it is the shortest on the piece as it was before the
/// cuts (`geodesicPath`), and is parted where that piece is: no length is lost. Points of pieces
/// that were never one are not joined.
/// @param results  one per piece, as drawn; null, or of another piece: not flat
/// @return by line, each from its beginning to its end; nothing for what is not finite
/// Cost: nothing without lines; else linear in the pieces, a search of a path for each pair of
/// points that is not joined straight, and the faces of the piece for each that is. Pure.
std::vector<InternalRun> findInternalRuns(const Garment& garment, const PieceResults& results,
                                          const std::vector<InternalLine>& lines);

/// What of a line or drill point lies to the left of a chord that is prolonged on both sides, as on
/// a half pattern; without `way`. Parts of a closed line are open. Pure.
std::vector<PieceInternal> leftPart(const PieceInternal& internal, const Chord& chord);

/// The same of open lines.
std::vector<Points2> leftParts(const std::vector<Points2>& lines, const Chord& chord);

/// Whether it is a drill point.
inline bool isDrillPoint(const PieceInternal& internal) {
    return internal.points.rows() == 1;
}

/// What is drawn of it, in flat coordinates: the line, to its first point again where it is closed;
/// of a drill point a closed circle as that of a dart's (`drillCircle`) and two strokes across it.
std::vector<Points2> drawnLines(const PieceInternal& internal);

}  // namespace toile
