// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A closed polyline in the plane, and a measure along it: arc lengths of its own, or those of
/// another line that it stands for. Places count on over any number of turns. Immutable.
class ClosedLine {
public:
    /// Measured along itself. @param points  #n x 2, n >= 3, the first not repeated
    explicit ClosedLine(Points2 points);
    /// @param arc  #n + 1, ascending: of each point, and of the first again, a turn later
    ClosedLine(Points2 points, std::vector<double> arc);

    int count() const { return static_cast<int>(points_.rows()); }
    const Points2& points() const { return points_; }
    const std::vector<double>& arc() const { return arc_; }
    double length() const { return arc_.back() - arc_.front(); }

    /// The place modulo the length, from that of the first point on.
    double wrap(double at) const;
    /// How far apart two places are along the line, the shorter way.
    double apart(double a, double b) const;
    /// The edge that a place lies on, which runs from point k to the next.
    int edgeAt(double at) const;
    Eigen::RowVector2d pointAt(double at) const;
    /// The place nearest to a point, the first of equals.  Cost: linear.
    double nearestPlace(const Eigen::RowVector2d& point) const;
    /// The same place on another line, which has as many points that stand for these.
    double placeOn(const ClosedLine& other, double at) const;
    /// By how much the line turns at a point, radians, positive to the left.
    double turnAt(int k) const;
    /// The part from one place to a later one: its ends and the points between them.
    Points2 part(double from, double to) const;
    /// Length of that part in the plane.
    double lengthOf(double from, double to) const;

private:
    /// Index of the first point after a place, counted on over turns.
    int after(double at) const;

    Points2 points_;
    std::vector<double> arc_;
};

}  // namespace toile
