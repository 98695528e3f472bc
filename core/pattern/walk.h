// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/garment/seam.h"
#include "core/geometry/line.h"
#include "core/geometry/placement.h"
#include "core/pattern/notches.h"
#include "core/pattern/pattern.h"
#include "core/pattern/segments.h"

namespace toile {

/// Position of a place along its seam: the mean of the shares of both sides' 3D lengths, 0 to 1,
/// which does not depend on the side that is called left. Pure.
double shareOf(const Seam& seam, const SeamMatch& place);

/// The place at a share, and at an arc length on one of the sides, clamped to the ends.
/// Precondition: the seam has matches.  Cost: their logarithm. Pure.
SeamMatch placeAtShare(const Seam& seam, double share);
SeamMatch placeOnSide(const Seam& seam, bool onRight, double arc);

/// A drawn outline or rim of a hole. A place between its points is interpolated by the target
/// lengths of the edges.
struct DrawnLoop {
    geometry::Line byArc,
        target;  ///< the exact outline: by arc lengths in 3D, and by target lengths
    geometry::Line byTarget, flat;  ///< the drawn line: by target, and by length in the plane

    /// The target length along the line up to a place in 3D, over any number of turns.
    double targetAt(double arc) const { return byArc.placeOn(target, arc); }
    /// The drawn length.
    double flatAt(double arc) const { return byTarget.placeOn(flat, targetAt(arc)); }
    /// The place in the plane.
    Eigen::RowVector2d pointAt(double arc) const { return flat.pointAt(flatAt(arc)); }
};

/// The drawn loops of a garment, each made on first use; not thread-safe.
class DrawnLoops {
public:
    /// @param results  one per piece; must outlive this
    explicit DrawnLoops(const PieceResults& results) : results_(results) {}

    bool isFlat(const SeamSide& side) const;
    /// Precondition: `isFlat`.  Cost: linear in the loop, once.
    const DrawnLoop& of(const SeamSide& side);

private:
    const PieceResults& results_;
    std::map<std::pair<int, int>, DrawnLoop> loops_;
};

/// Walked lengths of a seam in the pattern, mm.
struct WalkedLengths {
    double left = 0, right = 0;
    double ease = 0;  ///< by how much the left one is meant to be longer

    /// The unintended difference.
    double error() const { return left - right - ease; }
};

/// From the start of a seam to a place on it. Its ease (`easeOf`) lies where the outlines' targets
/// put it (`PieceResult::targets`; else as in 3D); the rest of the ease is spread evenly along the
/// seam.
/// @param left, right  the loops of its two sides, as drawn  Precondition: the seam has matches.
/// Cost: logarithmic. Pure.
WalkedLengths walkedTo(const Seam& seam, const DrawnLoop& left, const DrawnLoop& right,
                       const SeamMatch& place);

/// A place at which the two sides of a seam are aligned: its start, a notch or its end; and the
/// lengths from the station before, 0 at the start.
struct WalkStation : WalkedLengths {
    SeamMatch at{};                ///< arc lengths in 3D on both outlines
    int notch = -1;                ///< index into the seam's notches; -1: an end without one
    std::optional<double> kink{};  ///< at an end, as drawn, if it has one (`findSeamEnds`)
};

struct SeamWalk {
    int seam = -1;                        ///< index into the graph
    std::vector<WalkStation> stations{};  ///< from its start to its end, at least two

    double largestError() const;  ///< absolute value
};

/// Errors up to this are rounding, mm.
inline constexpr double kWalkTolerance = 1e-6;

/// Walks along every sewn seam whose sides are both flat, as a pattern maker does, from notch to
/// notch (`walkedTo`); the errors of a seam's stations add up to SeamMeasure::errorMm.
/// @param segments  of the exact outlines  @param notches  per seam (`findNotches`)
/// @return by seam  Cost: linear in the outlines, and stations. Pure.
std::vector<SeamWalk> walkSeams(const Garment& garment, const PieceResults& results,
                                const std::vector<OutlineSegments>& segments,
                                const std::vector<std::vector<Notch>>& notches);

struct WalkedGarment {
    std::vector<std::vector<Notch>> notches;  ///< per seam
    std::vector<SeamWalk> walks;              ///< by seam
};

/// The same with the notches of these rules; empty: the usual ones.
/// @param pattern  of the results  Cost: that of `findNotches` and `walkSeams`. Pure.
WalkedGarment walkGarment(const Garment& garment, const PieceResults& results,
                          const Pattern& pattern, const std::optional<NotchRules>& rules);

/// A seam of the pattern at a place of its walk: the right side's piece rolled along the left
/// side's.
struct RolledPlace {
    SeamMatch at{};          ///< arc lengths in 3D on both outlines, mm
    Placement motion{};      ///< from the right piece's flat coordinates to the left one's; proper
    WalkedLengths walked{};  ///< from the start
};

/// The walk of a seam as an animation. Pattern makers lay one piece with its seam line on the
/// other's and roll it along: at every share of the seam the two places that are sewn together
/// coincide, and the lines touch there. Their directions are those of chords (`kHalfChord`) that
/// end where the seam does, so that the motion is as continuous as the lines are, over their
/// corners too. Pieces of equal winding have their cloth on opposite sides of the line; if a seam
/// joins a piece to itself, a second copy is rolled. Immutable.
class SeamRoll {
public:
    /// @param loops  as drawn  Precondition: the seam has matches, and both its sides are flat.
    SeamRoll(Seam seam, DrawnLoops& loops);

    const Seam& seam() const { return seam_; }
    /// @param share  along the seam (`shareOf`), in [0, 1]  Cost: logarithmic.
    RolledPlace at(double share) const;
    /// The two outlines or rims that roll on each other.
    const DrawnLoop& left() const { return left_; }
    const DrawnLoop& right() const { return right_; }

private:
    /// Direction of a side in the plane at a place, radians.
    double directionAt(const SeamSide& side, const DrawnLoop& loop, double arc) const;

    Seam seam_;
    DrawnLoop left_, right_;
};

}  // namespace toile
