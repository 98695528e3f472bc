// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/ready_to_cut.h"

namespace toile {

/// Adds the findings of the proof (the pattern sewn back together): a doubtful mean gap, and faults
/// found before sewing. A seam that slips is reported once, by its lengths (`SeamLengths`). A piece
/// that is not flat, or crosses itself, has its own finding. Adds nothing if the plan has no proof,
/// or one with another number of pieces. Precondition: there is a garment. Cost: that of measuring
/// the seams that slip. Pure.
void checkProof(const CutPlan& plan, FindingList& found);

}  // namespace toile
