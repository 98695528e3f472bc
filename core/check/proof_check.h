// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/ready_to_cut.h"

namespace toile {

/// What the pattern, sewn back together, says of itself: a mean gap that is doubtful, and what was
/// wrong before anything was sewn. A seam that slips is told once, by its lengths (`SeamLengths`),
/// and a piece that is not flat, or crosses itself, by its own finding. A plan without a proof, or
/// with that of another number of pieces, has nothing to say. Precondition: there is a garment.
/// Cost: that of measuring the seams that slip. Pure.
void checkProof(const CutPlan& plan, FindingList& found);

}  // namespace toile
