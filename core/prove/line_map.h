// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/geometry/line.h"

namespace toile::prove {

/// How a closed line of a file lies on one of ours, as a whole: places at equal shares of their
/// lengths, turned and moved. The file's may be larger or smaller.
struct RoughFit {
    double angle = 0;     ///< that turns it, anti-clockwise, radians
    double offset = 0;    ///< share of its length at which ours begins
    double distance = 0;  ///< mm, root mean square of the two at ours' size
};

/// Turned by one of the given angles, the first that fits about as well as any; else as it fits
/// best. Both lines run the same way.  Cost: constant, some 30 thousand steps. Pure.
RoughFit roughFit(const geometry::Line& ours, const geometry::Line& theirs,
                  const std::vector<double>& angles);
/// Turned by this angle, no other.
RoughFit roughFitAt(const geometry::Line& ours, const geometry::Line& theirs, double angle);

/// The mean of places at even shares of a line's length.
Eigen::RowVector2d middleOf(const geometry::Line& line);

/// Which place of their line is which of ours: corner by corner, between these by length.
class LineMap {
public:
    /// Corners (`findCorners`) are paired in order, the nearest of those that turn alike; where
    /// none are, the line is followed from where the fit has it. @param theirs  as the fit turns it
    LineMap(const geometry::Line& ours, const geometry::Line& theirs, const RoughFit& fit);
    /// The same line.
    explicit LineMap(double length) : ours_({0, length}, true), theirs_(ours_) {}

    /// Of both lines measured along themselves, over any number of turns.
    double theirsAt(double ours) const { return ours_.placeOn(theirs_, ours); }

private:
    geometry::Arc ours_, theirs_;  ///< of the paired corners
};

}  // namespace toile::prove
