// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/pattern/darts.h"

namespace toile {

/// mm: darts that open by no more, which rounding leaves, do not open.
inline constexpr double kNoIntake = 1e-6;

/// The mirror image of a point in a line. @param along  of length 1
inline Eigen::Vector2d mirroredIn(const Eigen::Vector2d& from, const Eigen::Vector2d& along,
                                  const Eigen::Vector2d& point) {
    const Eigen::Vector2d rest = point - from;
    return from + 2 * along.dot(rest) * along - rest;
}

/// Gives the darts of a piece, which are complete otherwise, their caps and the ends of their folds
/// (`findDarts` says how).
void addDartCaps(const PatternPiece& piece, const geometry::Line& outline,
                 std::vector<PieceDart>& darts);

}  // namespace toile
