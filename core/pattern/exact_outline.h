// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "core/geometry/line.h"
#include "core/pattern/outline_reference.h"

namespace toile {

/// An outline with two measures along it: arc length in 3D and length in the plane.
class ExactOutline {
public:
    explicit ExactOutline(const OutlineReference& reference)
        : byArc_(geometry::Line::closed(reference.points, reference.arc)),
          flat_(geometry::Line::closed(reference.points)),
          turnIn3d_(reference.turn) {}

    const geometry::Line& flat() const { return flat_; }
    const geometry::Line& byArc() const { return byArc_; }

    /// Converts an arc length in 3D to a length in the plane, over any number of turns; and back.
    double flatAt(double arc) const { return byArc_.placeOn(flat_, arc); }
    double arcAt(double flat) const { return flat_.placeOn(byArc_, flat); }
    /// Turn at a vertex; ambiguous by full turns, which are chosen as in 3D.
    double turnAt(int k) const {
        return turnIn3d_[k] + std::remainder(flat_.turnAt(k) - turnIn3d_[k], 2 * std::numbers::pi);
    }

private:
    geometry::Line byArc_, flat_;
    std::vector<double> turnIn3d_;
};

}  // namespace toile
