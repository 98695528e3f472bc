// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The vertices that a rim keeps when it gets edges of another length: its corners, and others
/// about an edge's length apart. The polygon through them is up to 0.3 % shorter than the rim. Any
/// vertices of the rim between them may go, or slide along it, within that bound.
/// @param edgeLength  mm, > 0
/// @return in order along the rim; at least its first vertex
/// Cost: n log n. Pure.
std::vector<int> findRimCorners(const Points3& V, const RimLoop& rim, double edgeLength);

}  // namespace toile
