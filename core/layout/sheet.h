// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/pattern/pattern.h"

namespace toile {

/// Pieces laid side by side. `offset[i]` moves piece i of the pattern to its place; the whole lies
/// in [0, width] x [0, height], millimetres, y up.
struct Sheet {
    std::vector<Eigen::Vector2d> offset;
    double width = 0, height = 0;
};

/// 20 mm, or a tenth of the largest side of any piece where that is smaller, so that garments of
/// any scale keep their digits.
double gapBetweenPieces(double largestSide);

/// Lays pieces in rows by their bounding boxes, in pattern order, with a gap between them; no two
/// boxes overlap. The gap is `gapBetweenPieces`.
Sheet layOutInRows(const Pattern& pattern);

/// The same of what fills these boxes; an empty box takes no room but the gap.
Sheet layOutInRows(std::span<const Eigen::AlignedBox2d> boxes);

}  // namespace toile
