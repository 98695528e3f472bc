// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace toile {

/// On which side of the line from a to b the point c lies: 1 left of it (a, b, c anti-clockwise),
/// -1 right of it, 0 exactly on it. Exact for all finite coordinates whose products neither
/// overflow nor underflow (sizes between 1e-140 and 1e140): plain arithmetic where its error bound
/// allows, else the determinant as a sum of doubles without error ([She97]).
/// Cost: a few operations; about a hundred where the points are almost in line. Pure.
int exactOrientation(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b,
                     const Eigen::RowVector2d& c);

}  // namespace toile
