// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/geometry/line.h"

namespace toile::prove {

/// Rigid fit of a closed line of a file to one of ours: places at equal shares of their lengths,
/// rotated and moved. The file's line may be larger or smaller.
struct RoughFit {
    double angle = 0;     ///< of its rotation, anti-clockwise, radians
    double offset = 0;    ///< share of its length at which our line begins
    double distance = 0;  ///< mm, root mean square of the two at our line's size
};

/// Rotated by one of the given angles, the first that fits about as well as any; else by the best
/// angle. Both lines run in the same direction.  Cost: constant, some 30 thousand steps. Pure.
RoughFit roughFit(const geometry::Line& ours, const geometry::Line& theirs,
                  const std::vector<double>& angles);
/// Rotated by exactly this angle.
RoughFit roughFitAt(const geometry::Line& ours, const geometry::Line& theirs, double angle);

/// The mean of places at even shares of a line's length.
Eigen::RowVector2d middleOf(const geometry::Line& line);

/// Map between places of a line of the file and of ours: corner by corner, by length in between.
class LineMap {
public:
    /// Pairs corners (`findCorners`) in order, the nearest with similar turns; without pairs,
    /// follows the line from the start of the fit. The file's line is rotated as in the fit.
    LineMap(const geometry::Line& ours, const geometry::Line& theirs, const RoughFit& fit);
    /// Map of a line to itself.
    explicit LineMap(double length) : ours_({0, length}, true), theirs_(ours_) {}

    /// Places on both lines are arc lengths, over any number of turns.
    double theirsAt(double ours) const { return ours_.placeOn(theirs_, ours); }

private:
    geometry::Arc ours_, theirs_;  ///< of the paired corners
};

}  // namespace toile::prove
