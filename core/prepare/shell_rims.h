// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/edge_table.h"
#include "core/prepare/shell_sides.h"
#include "core/prepare/two_sided.h"

namespace toile::shell {

/// 1 - cosine of the angle up to which two triangles are one surface, whatever is opposite: 40
/// degrees, as a rim turns by 90.
inline constexpr double kSmooth = 0.23;
/// Two triangles that share an edge.
struct Neighbours {
    int a, b;
    double bend;    ///< 1 - cosine of the angle between them
    double length;  ///< of the edge, mm
};

/// All pairs that share an edge. Cost: linear.
std::vector<Neighbours> neighboursOf(const Surface& surface, const EdgeTable& table);

/// Assigns each patch of single triangles to its surroundings: those it joins smoothly, or else all
/// around; a narrow one between the two surfaces is a rim. Small islands of one surface in the
/// other are reassigned to the other.
/// @param thickness  of the cloth, mm   @param sets  are joined with the surroundings
void fillIn(const Surface& surface, const Pairs& pairs, const std::vector<Neighbours>& neighbours,
            double thickness, TwoSided& sets, Sides& sides);

/// Marks parts as single if their edges are not those of a shell: a folded sheet has openings along
/// both of its layers.
void dropFolded(const Surface& surface, const EdgeTable& table, TwoSided& sets, Sides& sides);

}  // namespace toile::shell
