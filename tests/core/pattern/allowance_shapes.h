// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/pattern/piece_allowance.h"

namespace toile::test {

/// A seam line with its stretches.
struct AllowanceCase {
    Points2 seamLine;
    std::vector<AllowanceStretch> stretches;

    Points2 cut() const { return cuttingLine(seamLine, stretches); }
};

/// An outline of 3 to 300 points that does not cross itself, round or wavy, smooth, jagged or with
/// long spikes, with stretches, widths of 0 to 40 mm and rules at random; the same for the same
/// seed.
AllowanceCase randomAllowances(unsigned seed);

/// Every point turned about the origin, then moved.
AllowanceCase moved(AllowanceCase shape, double angle, const Eigen::RowVector2d& by);
/// The mirror image in the y axis, which runs the other way round.
AllowanceCase mirrored(const AllowanceCase& shape);

/// How far a point is from the polyline from one of its points to a later one, which may be counted
/// on over the last, and whether it is nearest to one of its ends or from inside the line.
struct NearestPlace {
    double distance = 0;
    bool atEnd = false, fromOutside = false;
};
NearestPlace nearestPlace(const Eigen::RowVector2d& point, const Points2& line, int first,
                          int last);
double distanceTo(const Eigen::RowVector2d& point, const Points2& closedLine);
/// How far a point is from the outside of an anti-clockwise line, negative inside it.
double outside(const Eigen::RowVector2d& point, const Points2& closedLine);
/// The largest distance of a point of one closed line to the other, and the other way round.
double apart(const Points2& a, const Points2& b);
double areaOf(const Points2& closedLine);

/// What is wrong with any cutting line whatever: it crosses itself, runs the wrong way, inside the
/// seam line or inside an allowance (but beside corners that fold back), or too far out; empty
/// where nothing is.
std::string troubleWith(const AllowanceCase& shape, const Points2& cut);

}  // namespace toile::test
