// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/seam/choose_runs.h"

namespace toile {

/// Makes runs one that follow each other on both outlines, with nothing or only a few free edges
/// between them. `taken` are the places of all runs per piece; bridges are added to it.
std::vector<Chosen> joinRuns(const Outlines& outlines, std::vector<Chosen> runs,
                             std::vector<ArcSet>& taken);

}  // namespace toile
