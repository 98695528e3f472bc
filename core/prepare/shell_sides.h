// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/prepare/shell.h"
#include "core/prepare/shell_pairs.h"

namespace toile::shell {

/// The side of each triangle.
struct Sides {
    std::vector<ShellSide> side;  ///< per triangle
    std::vector<char> turned;     ///< per triangle: runs clockwise, seen from outside
};

/// Whether it is one of the two surfaces.
inline bool isSide(ShellSide side) {
    return side == ShellSide::Outer || side == ShellSide::Inner;
}

/// Divides the triangles into the two surfaces: smoothly joined triangles are one surface, opposite
/// ones the other. If both relations hold for the same triangles, they are not a shell, and single.
Sides findSides(const Surface& surface, const Pairs& pairs);

}  // namespace toile::shell
