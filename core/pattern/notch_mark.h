// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/line.h"
#include "core/mesh/mesh_arrays.h"
#include "core/pattern/line_settings.h"
#include "core/pattern/pattern.h"

namespace toile {

/// A place on a seam line in the plane, mm.
struct NotchSpot {
    Eigen::Vector2d point{0, 0};
    Eigen::Vector2d outward{0, 0};  ///< unit, at right angles to the line, away from the cloth
};

/// The direction of a drawn line at a place is that of the chord this far to either side, mm.
inline constexpr double kHalfChord = 1;

/// The spot at a place on a drawn outline or rim that has the cloth on its left.
/// @param line  in the units of `place`  Precondition: longer than two half chords.
/// Cost: logarithmic. Pure.
NotchSpot notchSpot(const geometry::Line& line, double place);

/// Measures of a notch as drawn, mm.
struct NotchSize {
    double depth = 5;    ///< from the cutting line inwards; NotchRules::depth
    double width = 5;    ///< of V and castle at the cutting line, of the bar of a T
    double spacing = 8;  ///< between the two of a double notch
};

/// A notch on the cutting line, at right angles to the seam line: open polylines, #n x 2, one per
/// stroke. It is no deeper than half the allowance; without allowance it goes into the cloth.
/// - Slit: from the cutting line inwards.
/// - V: two corners on the cutting line, the tip inwards.
/// - T: a slit with a bar at its inner end.
/// - Castle: three sides of a rectangle, open at the cutting line.
/// @param allowance  its width there, mm, 0 or more; the cutting line is parallel to the seam line
/// @param count      1, or 2: side by side along the line, about the spot
/// Pure.
std::vector<Points2> notchStrokes(const NotchSpot& spot, double allowance, NotchForm form,
                                  int count, const NotchSize& size = {});

/// The line on which places of notches are measured: the rim of a hole, or the outline (-1). For a
/// half pattern it is the outline of the whole piece, so that a notch near the fold is at right
/// angles to the line of the unfolded cloth.  Cost: linear. Pure.
geometry::Line notchLine(const PatternPiece& piece, int hole);

/// The strokes of each notch of a piece, in its own coordinates. For a half pattern only the parts
/// on its side of the fold.
/// @param pattern  source of the depth
/// @param form     empty: that of the pattern  Cost: linear in the lines, and per notch. Pure.
std::vector<std::vector<Points2>> notchMarks(const Pattern& pattern, const PatternPiece& piece,
                                             std::optional<NotchForm> form = {});

}  // namespace toile
