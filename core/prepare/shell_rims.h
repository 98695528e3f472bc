// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/edge_table.h"
#include "core/prepare/shell_sides.h"
#include "core/prepare/two_sided.h"

namespace toile::shell {

/// 1 - cosine of the angle up to which two triangles are one surface whatever lies opposite:
/// 40 degrees, as a rim turns by 90.
inline constexpr double kSmooth = 0.23;
/// Two triangles that share an edge.
struct Neighbours {
    int a, b;
    double bend;    ///< 1 - cosine of the angle between them
    double length;  ///< of the edge, mm
};

/// All that share an edge. Cost: linear.
std::vector<Neighbours> neighboursOf(const Surface& surface, const EdgeTable& table);

/// Takes each patch of single triangles for what surrounds it: what it joins smoothly, or else all
/// around; between the two surfaces a narrow one is a rim. Small islands of one surface in the
/// other are the other.
/// @param thickness  of the cloth, mm   @param sets  joined with what surrounds them
void fillIn(const Surface& surface, const Pairs& pairs, const std::vector<Neighbours>& neighbours,
            double thickness, TwoSided& sets, Sides& sides);

/// Makes single again what has not the edges of a shell: a sheet folded flat has openings that run
/// along both of its layers.
void dropFolded(const Surface& surface, const EdgeTable& table, TwoSided& sets, Sides& sides);

}  // namespace toile::shell
