// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/flatten/base/outline_targets.h"
#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"
#include "core/symmetry/symmetry.h"

namespace toile {

/// True where the ease of some seam is drawn.
bool drawsEase(const Garment& garment);

/// Lengths that the edges of the outlines are to have in the pattern, mm, where that is not their
/// length in 3D: common ones for seams that mirror each other; as typed for segments, on both sides
/// of the seam that one is part of; and for the longer side of seams whose ease is drawn. Lengths
/// change evenly along what they are said of; of two that were said of one place the later counts.
/// What is typed or drawn of one of two mirrored seams alone does not count for the other. Rims of
/// holes keep their lengths, and so does what is sewn to them.
/// @param symmetry  null: nothing is mirrored
/// @return one per piece  Cost: outlines, times what is said of each. Pure.
std::vector<OutlineTargets> outlineTargets(const Garment& garment, const LineSettings& settings,
                                           const Symmetry* symmetry = nullptr);

}  // namespace toile
