// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// An open line in fine steps, with what the smooth line that it stands for has: tangents, lengths,
/// and how far that line is off the chords. Immutable; keeps a reference to the points.
class FinePolyline {
public:
    /// @param points  #n x 2, mm, n >= 2, no two in a row alike
    /// @param length  mm: what the whole is long; the steps have their shares of it
    FinePolyline(const Points2& points, double length);

    int count() const { return static_cast<int>(points_.rows()); }
    Eigen::Vector2d point(int k) const { return points_.row(k); }
    /// Of the circle through a point and its neighbours; at the ends curvature goes on changing as
    /// it does beside them.
    const Eigen::Vector2d& tangent(int k) const { return tangents_[k]; }
    double length(int from, int to) const { return reached_[to] - reached_[from]; }
    /// How far an arc that bends like the line would stand off the chord of a step; 0 where the
    /// line bends to both sides.
    double sag(int step) const;

private:
    double curvature(int k) const { return 2 * turns_[k] / (steps_[k] + steps_[k - 1]); }
    bool isInside(int k) const { return k > 0 && k + 1 < count(); }
    double directionAt(int k) const;
    double directionAtEnd(int k) const;

    const Points2& points_;
    std::vector<double> steps_, directions_;  ///< of steps
    std::vector<double> turns_;               ///< at points; 0 at the ends
    std::vector<double> reached_;             ///< length from the first point to each
    std::vector<Eigen::Vector2d> tangents_;
};

}  // namespace toile
