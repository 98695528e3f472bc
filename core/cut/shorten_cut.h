// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cut/fill_holes.h"

namespace toile {

/// Pulls a cut tight, and lets an end that lies at a vertex of a rim slide along its loop from
/// vertex to vertex, as long as that makes the cut shorter. Cost: some dozens of straightenings.
PathPolyline shortenedCut(const SurfaceLinks& links, const std::vector<RimLoop>& rims,
                          const PathPolyline& cut);

}  // namespace toile
