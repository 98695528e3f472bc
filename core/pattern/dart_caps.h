// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/pattern/darts.h"

namespace toile {

/// mm: darts that open by no more than this are closed; the rest is rounding.
inline constexpr double kNoIntake = 1e-6;

/// The mirror image of a point in a line. @param along  unit length
inline Eigen::Vector2d mirroredIn(const Eigen::Vector2d& from, const Eigen::Vector2d& along,
                                  const Eigen::Vector2d& point) {
    const Eigen::Vector2d rest = point - from;
    return from + 2 * along.dot(rest) * along - rest;
}

/// Adds caps and the ends of folds to the otherwise complete darts of a piece (see `findDarts`).
void addDartCaps(const PatternPiece& piece, const geometry::Line& outline,
                 std::vector<PieceDart>& darts);

}  // namespace toile
