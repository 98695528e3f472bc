// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Two edges of a flat outline that cross each other. Edge i runs from loop vertex i to i + 1.
struct OutlineCrossing {
    int first, second;         ///< first < second
    Eigen::RowVector2d place;  ///< where, in the unit of Q
};

/// The search ends after this many crossings: such an outline is hopeless, and a longer list would
/// fill the memory.
inline constexpr int kMaxOutlineCrossings = 1000000;

/// Pairs of non-adjacent outline edges that cross each other, sorted by (first, second).
/// Orientation is exact, but points within 1e-12 of the outline's extent from a line count as on
/// it, so that the two coincident sides of a slit do not cross. Two stretches that touch cross only
/// if
/// - one passes through a corner or an edge of the other to its other side: reported for the edges
///   that start there; or
/// - they overlap in the same direction, so that the cloth is on the same side of both.
/// The search misses an outline that runs along another stretch in the opposite direction and
/// leaves it on the wrong side.
/// Cost: about n log n, also for a star of n thin spikes. Pure.
std::vector<OutlineCrossing> findOutlineCrossings(const Points2& Q,
                                                  const std::vector<int>& boundary);

/// True if no two outline edges cross, by the same rule. Stops at the first crossing.
bool outlineIsSimple(const Points2& Q, const std::vector<int>& boundary);

/// Number of crossings, at most `most`, that involve any edge from number `from` to the last.
/// Cost: linear for a few edges.
int crossingsFrom(const Points2& Q, const std::vector<int>& boundary, int from, int most);

}  // namespace toile
