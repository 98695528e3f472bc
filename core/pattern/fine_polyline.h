// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// An open line in fine steps, with properties of the smooth line that it represents: tangents,
/// lengths, and its distance from the chords. Immutable; keeps a reference to the points.
class FinePolyline {
public:
    /// @param points  #n x 2, mm, n >= 2, no two successive ones equal
    /// @param length  mm: length of the whole line; the steps get their shares of it
    FinePolyline(const Points2& points, double length);

    int count() const { return static_cast<int>(points_.rows()); }
    Eigen::Vector2d point(int k) const { return points_.row(k); }
    /// Tangent of the circle through a point and its neighbours; at the ends the curvature is
    /// extrapolated.
    const Eigen::Vector2d& tangent(int k) const { return tangents_[k]; }
    double length(int from, int to) const { return reached_[to] - reached_[from]; }
    /// Distance of an arc with the line's curvature from the chord of a step; 0 if the line bends
    /// to both sides.
    double sag(int step) const;

private:
    double curvature(int k) const { return 2 * turns_[k] / (steps_[k] + steps_[k - 1]); }
    bool isInside(int k) const { return k > 0 && k + 1 < count(); }
    double directionAt(int k) const;
    double directionAtEnd(int k) const;

    const Points2& points_;
    std::vector<double> steps_, directions_;  ///< of steps
    std::vector<double> turns_;               ///< at points; 0 at the ends
    std::vector<double> reached_;             ///< length from the first point to each point
    std::vector<Eigen::Vector2d> tangents_;
};

}  // namespace toile
