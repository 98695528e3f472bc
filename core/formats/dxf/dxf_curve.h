// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/formats/dxf/dxf_document.h"
#include "core/formats/pattern_file.h"

namespace toile {

/// Largest distance of a chord from its curve, mm. The chords of a full circle are shorter than the
/// circle by about twice this, whatever its radius.
inline constexpr double kDxfChordTolerance = 0.005;

/// Most points that the curves of a file may take, besides the vertices that it lists.
inline constexpr std::size_t kMaxCurvePoints = 5'000'000;

/// The error for a file whose curves take more: of a wrong unit, or too large for a pattern.
/// Cost: linear in the points, which are not counted beyond the limit. Pure.
/// @param unit  length of the file's unit, mm
std::optional<Error> refusalOfCurves(const DxfDocument& document, double unit);

/// The line that an entity draws, in the coordinates of the drawing or of its block: LINE,
/// LWPOLYLINE, POLYLINE (with bulges, curve-fit and spline-fit ones too), ARC, CIRCLE, ELLIPSE,
/// SPLINE by control points or by fit points. Closed lines do not repeat their first point. Returns
/// nothing for other entities and for unreadable lines: in a tilted plane, meshes, splines with
/// inconsistent numbers.
/// @param unit  approximate length of the entity's unit in the result, mm; for the tolerance
/// Cost: linear in the points. Pure.
std::optional<FileLine> dxfCurve(const DxfEntity& entity, double unit);

/// Joins open lines end to end. A chain is closed if it returns to its start, or ends within `gap`
/// of it. Closed lines stay closed; repeated consecutive points are removed. Chains are ordered by
/// their first line.
/// @param near  ends closer than this are joined, positive
/// Cost: about n log n. Pure.
std::vector<FileLine> joinedLines(const std::vector<FileLine>& lines, double near, double gap);

/// The mirror image of points across a line through two points that differ.
Points2 mirroredAcross(const Points2& points, const FileChord& line);

/// Completes a closed line that is one half of a symmetric line: removes its longest straight run
/// along the mirror line and adds the mirrored half. Returns the line unchanged if no part of it
/// lies on the mirror line, or if it extends to both sides.
/// @param near  points closer than this to the mirror line are on it
struct Unfolded {
    Points2 line = Points2(0, 2);
    bool isWhole = false;  ///< it was a half and is now complete
};
Unfolded unfolded(const Points2& closed, const FileChord& mirror, double near);

}  // namespace toile
