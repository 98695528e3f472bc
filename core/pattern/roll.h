// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/garment/seam.h"
#include "core/geometry/placement.h"
#include "core/pattern/seam_places.h"
#include "core/pattern/walk.h"

namespace toile {

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
