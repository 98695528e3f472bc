// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>

#include "core/flatten/base/piece_result.h"
#include "core/garment/seam.h"
#include "core/geometry/line.h"

namespace toile {

/// How far along its seam a place lies: the mean of the shares of both sides' 3D lengths, 0 to 1,
/// so that it is the same whichever side is called the left. Pure.
double shareOf(const Seam& seam, const SeamMatch& place);

/// The place at a share, and at an arc length on one of the sides. Beyond an end: that end.
/// Precondition: the seam has matches.  Cost: their logarithm. Pure.
SeamMatch placeAtShare(const Seam& seam, double share);
SeamMatch placeOnSide(const Seam& seam, bool onRight, double arc);

/// An outline, or the rim of a hole, as it is drawn. Between its points a place lies by what the
/// edges are to measure.
struct DrawnLoop {
    geometry::Line byArc,
        target;  ///< the exact one: by arc lengths in 3D, and by those it is to have
    geometry::Line byTarget, flat;  ///< the drawn one: by these, and by its lengths in the plane

    /// What the length along the line up to a place in 3D is to be, over any number of turns.
    double targetAt(double arc) const { return byArc.placeOn(target, arc); }
    /// What it is.
    double flatAt(double arc) const { return byTarget.placeOn(flat, targetAt(arc)); }
    /// The place in the plane.
    Eigen::RowVector2d pointAt(double arc) const { return flat.pointAt(flatAt(arc)); }
};

/// The drawn loops of a garment, each made when it is first asked for; not thread-safe.
class DrawnLoops {
public:
    /// @param results  one per piece, which stay while this lives
    explicit DrawnLoops(const PieceResults& results) : results_(results) {}

    bool isFlat(const SeamSide& side) const;
    /// Precondition: `isFlat`.  Cost: linear in the loop, once.
    const DrawnLoop& of(const SeamSide& side);

private:
    const PieceResults& results_;
    std::map<std::pair<int, int>, DrawnLoop> loops_;
};

}  // namespace toile
