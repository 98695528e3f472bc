// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/seam/find_seams.h"
#include "core/seam/run.h"

namespace toile {

/// A run that has its place.
struct Chosen {
    Run run;
    bool stacked = false;  ///< side b lies on a place that another run has
};

/// Decides between runs that compete for a place, so that each place of an outline is in one run at
/// most (but for stacked layers). Runs are cut where others begin and end; the parts are taken in
/// order of their gap, then of what their run has undisputed, then of length; parts of a run that
/// follow each other are one again. Cost: n log n where few runs lie on one place.
std::vector<Chosen> chooseRuns(const Outlines& outlines, const std::vector<Run>& candidates,
                               const SeamOptions& options);

/// Makes runs one that follow each other on both outlines, with nothing or only a few free edges
/// between them. `taken` are the places of all runs per piece; bridges are added to it.
std::vector<Chosen> joinRuns(const Outlines& outlines, std::vector<Chosen> runs,
                             std::vector<ArcSet>& taken);

}  // namespace toile
