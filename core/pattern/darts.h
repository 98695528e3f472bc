// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "core/mesh/mesh_arrays.h"
#include "core/pattern/grain_line.h"
#include "core/pattern/pattern.h"

namespace toile {

/// Darts in the pattern. The outline runs from the mouth along the first leg to the tip and along
/// the second leg back to the mouth; what lies between the legs is no part of the piece yet, and
/// stays in the cloth as the dart that is folded and sewn.

/// The drill point is so far before the tip, mm; a third of the leg where that is less.
inline constexpr double kDrillBeforeTip = 12;

/// At the tip, radians: from there on the mouth is wider than the legs are long. Folded, such cloth
/// reaches beyond the legs: what opens so wide is a hollow corner, as of a box, and no dart. A
/// little below 60 degrees, a common angle, which rounding is not to decide.
inline constexpr double kWidestDart = 1.0471975511965976 - 1e-6;

/// A dart as it lies in the pattern.
struct PieceDart {
    int seam = 0;  ///< SeamLine::number
    /// Arc lengths along `PatternPiece::outline`, from the mouth over the tip to the mouth: `from`
    /// within the first turn, `to` counted on.
    double from = 0, to = 0;
    Eigen::Vector2d tip{0, 0};
    Chord mouth{{0, 0}, {0, 0}};  ///< where the first leg begins, where the second ends
    double intake = 0;            ///< between them, mm
    bool isTyped = false;         ///< a person has said how large the intake is to be
    /// At the tip between the chords of both legs, radians; below 0 where the legs cross.
    double angle = 0;
    double leg = 0;  ///< length of the first leg along the line, mm; of the second too, as sewn
    DartLay lay = DartLay::First;
    /// The line on which the cloth between the legs ends, from the mouth's first end to the second.
    /// Empty where there is no such cloth, or no room for it: the dart stays open.
    Points2 cap{};
    /// From the tip to where the fold leaves the cap; both the tip where there is no cap.
    Chord fold{{0, 0}, {0, 0}};
    /// On the fold, in the dart's cloth; the tip where there is no cap.
    Eigen::Vector2d drill{0, 0};
};

/// The darts of a piece, by `from`: seams of kind Dart with both sides on the outline, one of which
/// ends where the other begins, at less than kWidestDart. Turn points on a leg change nothing. One
/// across the fold of a half pattern has but one side there, and is not found.
///
/// The cap. The dart is folded on the line that halves the angle at its tip, sewn along the legs
/// and laid over one of them. For the seam to run straight on then, the half beside that leg is to
/// end on the piece's own line beyond the leg: its cap is that line mirrored in the leg, up to the
/// fold, and the other half is its mirror image in the fold.
/// - Of a curved leg the chord of the last kDartMouth at the mouth is taken for the mirror. Where
///   tip and mouth are no isosceles triangle, as with legs of two curves, the mirror image in the
///   fold is turned and scaled about the fold's end to end in the mouth.
/// - The line beyond reaches to the next corner or dart, at most kLongestFold times as far as the
///   tip is from the mouth; from there on it is prolonged straight.
/// - Where it does not meet the fold within that distance of the tip, or the cap would cross the
///   outline or another cap, the cap is the straight line between the mouth's ends; where that
///   crosses too, there is none. None either where the legs cross (angle < 0). Legs that cross on
///   their way but are open at the mouth do not matter: the cap is about the mouth.
///
/// Which leg: by the convention that an upright dart is laid towards the centre and a level one
/// downwards. Up is along the grain. The core does not know the centre: it takes the middle of the
/// piece's area, of a half pattern that of the whole piece. A dart that points at it is laid over
/// its first leg.
/// `PatternPiece::saidOfDarts` may say otherwise.
/// Cost: outline times caps. Pure.
std::vector<PieceDart> findDarts(const PatternPiece& piece);

inline constexpr double kDartMouth = 10;   ///< mm
inline constexpr double kLongestFold = 3;  ///< times the distance of tip and mouth

inline constexpr double kDrillRadius = 1.5;  ///< mm

/// The circle that is drawn for a drill point: closed, 24 points.
Points2 drillCircle(const Eigen::Vector2d& centre);

/// What is drawn of a dart besides its legs.
struct DartMarks {
    Points2 fold;                  ///< open, to be dashed; empty where there is no cap
    Points2 drill;                 ///< `drillCircle`; empty likewise
    std::array<Points2, 2> cross;  ///< at the tip: two strokes of 5 mm, along the fold and square
};

/// Pure.
DartMarks dartMarks(const PieceDart& dart);

}  // namespace toile
