// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/flatten/base/outline_targets.h"
#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"
#include "core/symmetry/symmetry.h"

namespace toile {

/// True if the ease of some seam is drawn.
bool drawsEase(const Garment& garment);

/// Target lengths of the outline edges in the pattern, mm, if they differ from the lengths in 3D:
/// common lengths for seams that mirror each other; set lengths of segments, on both sides of their
/// seam; and for the longer side of seams with drawn ease. Lengths change evenly along the stretch
/// they apply to; of two settings for the same place the later counts. Lengths or ease of one of
/// two mirrored seams do not apply to the other. Rims of holes keep their lengths, and so do edges
/// sewn to them.
/// @param symmetry  null: nothing is mirrored
/// @return one per piece  Cost: outlines, times the settings of each. Pure.
std::vector<OutlineTargets> outlineTargets(const Garment& garment, const LineSettings& settings,
                                           const Symmetry* symmetry = nullptr);

}  // namespace toile
