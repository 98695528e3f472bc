// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/seam/run.h"

namespace toile {

/// A part of a candidate run: the unit of choice.
struct Part {
    int parent = 0;  ///< the candidate run
    Run run;
    double cost = 0;         ///< gap relative to the local edge length, 0 where it coincides
    bool contested = false;  ///< another part lies on the same place
};

/// Cuts every run at the places where others begin or end on either of its outlines, and finds out
/// which parts compete.
std::vector<Part> cutIntoParts(const Outlines& outlines, const std::vector<Run>& runs);

}  // namespace toile
