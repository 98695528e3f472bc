// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/prepare/shell.h"
#include "core/prepare/shell_pairs.h"

namespace toile::shell {

/// Which triangle lies on which side.
struct Sides {
    std::vector<ShellSide> side;  ///< per triangle
    std::vector<char> turned;     ///< per triangle: runs clockwise, seen from outside
};

/// Whether it is one of the two surfaces.
inline bool isSide(ShellSide side) {
    return side == ShellSide::Outer || side == ShellSide::Inner;
}

/// Parts the triangles into the two surfaces: what joins smoothly is one surface, what lies
/// opposite the other. Where both are said of the same triangles they are no shell's, and single.
Sides findSides(const Surface& surface, const Pairs& pairs);

}  // namespace toile::shell
