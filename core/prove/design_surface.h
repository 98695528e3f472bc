// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/garment/garment.h"

namespace toile::prove {

/// The garment as it was designed: its pieces, joined along their seams (`sew::cutAlongSeams`), all
/// running the way that the first of those joined to each other does.
/// Errors: NoGeometry.  Cost: that of joining. Pure.
Result<MeshArrays> designSurface(const Garment& garment);

}  // namespace toile::prove
