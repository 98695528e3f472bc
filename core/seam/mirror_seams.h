// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/garment/garment.h"

namespace toile {

/// Names the seams along which a completed half meets its mirror image: "mirror seam", or "mirror
/// seam 1", "mirror seam 2" in the order of the graph. Seams made by a cut keep their name. Names
/// stay unique.
/// @param seams  of the garment's pieces  Cost: the vertices of the seams. Pure.
void nameMirrorSeams(SeamGraph& seams, const Garment& garment);

}  // namespace toile
