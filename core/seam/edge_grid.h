// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/seam/outline.h"

namespace toile {

/// All pairs (a < b) of outline edges, not in `skip`, that may come within the sum of their reaches
/// (mm, per edge) of each other, each once, sorted. Edges are entered in a uniform grid in bits no
/// longer than a cell, so that uneven sampling costs no more than the outline's length.
/// Cost: grid-linear and two sorts.
std::vector<std::pair<int, int>> nearbyEdges(const Outlines& outlines,
                                             const std::vector<char>& skip,
                                             const std::vector<double>& reach);

}  // namespace toile
