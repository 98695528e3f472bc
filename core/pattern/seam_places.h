// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>

#include "core/flatten/base/piece_result.h"
#include "core/garment/seam.h"
#include "core/geometry/line.h"

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

}  // namespace toile
