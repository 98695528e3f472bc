// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "core/mesh/mesh_arrays.h"
#include "core/pattern/pattern.h"

namespace toile {

/// Darts in the pattern. The outline runs from the mouth along the first leg to the tip and along
/// the second leg back to the mouth. The area between the legs is not part of the piece yet; its
/// cloth stays as the dart that is folded and sewn.

/// Distance of the drill point from the tip, mm; at most a third of the leg.
inline constexpr double kDrillBeforeTip = 12;

/// Angle at the tip, radians, from which the mouth is wider than the legs are long. Folded, such
/// cloth would reach beyond the legs: so wide an opening is a hollow corner, as of a box, and no
/// dart. Slightly below 60 degrees, a common angle, so that rounding does not decide.
inline constexpr double kWidestDart = 1.0471975511965976 - 1e-6;

/// The darts of a piece, sorted by `from`: seams of kind Dart with both sides on the outline, one
/// ending where the other starts, at less than kWidestDart. Turn points on a leg are ignored. A
/// dart across the fold of a half pattern has only one side there and is not found.
///
/// The cap. The dart is folded on the bisector of the angle at its tip, sewn along the legs and
/// laid over one of them. For the seam to continue straight, the half beside that leg must end on
/// the piece's own line beyond the leg: its cap is that line mirrored in the leg, up to the fold,
/// and the other half is its mirror image in the fold.
/// - The mirror of a curved leg is the chord of its last kDartMouth at the mouth. If tip and mouth
///   form no isosceles triangle, as with legs of two curves, the mirror image in the fold is turned
///   and scaled about the fold's end to end in the mouth.
/// - The line beyond reaches to the next corner or dart, at most kLongestFold times the distance
///   from tip to mouth; from there it is prolonged straight.
/// - If it does not meet the fold within that distance of the tip, or if the cap would cross the
///   outline or another cap, the cap is the straight line across the mouth. If that crosses too, or
///   if the legs cross (angle < 0), there is no cap. Legs that cross on their way but are open at
///   the mouth are allowed: the cap depends on the mouth.
///
/// The leg follows the convention that an upright dart is laid towards the centre and a level one
/// downwards. Up is along the grain. The core does not know the centre and uses the centroid of the
/// piece's area, for a half pattern that of the whole piece. A dart that points at it is laid over
/// its first leg.
/// `PatternPiece::statedDarts` takes precedence.
/// Cost: outline times caps. Pure.
std::vector<PieceDart> findDarts(const PatternPiece& piece);

inline constexpr double kDartMouth = 10;   ///< mm
inline constexpr double kLongestFold = 3;  ///< times the distance from tip to mouth

inline constexpr double kDrillRadius = 1.5;  ///< mm

/// The circle drawn for a drill point: closed, 24 points.
Points2 drillCircle(const Eigen::Vector2d& centre);

/// The marks of a dart besides its legs.
struct DartMarks {
    Points2 fold;                  ///< open, drawn dashed; empty if there is no cap
    Points2 drill;                 ///< `drillCircle`; empty likewise
    std::array<Points2, 2> cross;  ///< at the tip: strokes of 5 mm, along and across the fold
};

/// Pure.
DartMarks dartMarks(const PieceDart& dart);

}  // namespace toile
