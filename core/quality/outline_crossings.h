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

/// The search ends after this many crossings: an outline with more is hopeless, and its list would
/// fill the memory.
inline constexpr int kMaxOutlineCrossings = 1000000;

/// Pairs of outline edges, not neighbours, that cross each other, by (first, second).
/// Sides are decided exactly, but what lies within 1e-12 of the outline's extent from a line counts
/// as lying on it, so that the two sides of a slit, which lie on each other, do not cross. Two
/// stretches that touch cross only where
/// - one passes through a corner or an edge of the other to its other side: named for the edges
///   that start there;
/// - they lie on each other in the same direction, hence the cloth on the same side of both.
/// An outline that runs along another stretch in the opposite direction and leaves it on the wrong
/// side is not seen as crossing.
/// Cost: about n log n, on a star of n thin spikes too. Pure.
std::vector<OutlineCrossing> findOutlineCrossings(const Points2& Q,
                                                  const std::vector<int>& boundary);

/// True where no two outline edges cross, by the same rule. Ends at the first crossing found.
bool outlineIsSimple(const Points2& Q, const std::vector<int>& boundary);

/// How many crossings, counted to `most`, the edges `from`, from + 1, ... to the last take part in.
/// Cost: linear for a few edges.
int crossingsFrom(const Points2& Q, const std::vector<int>& boundary, int from, int most);

}  // namespace toile
