// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/pattern/pattern.h"

namespace toile {

/// Pieces laid side by side. `offset[i]` moves piece i of the pattern to its place; the whole lies
/// in [0, width] x [0, height], millimetres, y up.
struct Sheet {
    std::vector<Eigen::Vector2d> offset;
    double width = 0, height = 0;
};

/// Lays pieces in rows by their bounding boxes, in pattern order, with a gap between them; no two
/// boxes overlap. The gap is 20 mm, or a tenth of the largest piece where that is smaller, so
/// that garments of any scale keep their digits.
Sheet layOutInRows(const Pattern& pattern);

}  // namespace toile
