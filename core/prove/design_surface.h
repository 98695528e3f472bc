// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/garment/garment.h"

namespace toile::prove {

/// The surface of the designed garment: its pieces, joined along their seams
/// (`sew::cutAlongSeams`), all oriented like the first of those joined to each other.
/// Errors: NoGeometry.  Cost: that of joining. Pure.
Result<MeshArrays> designSurface(const Garment& garment);

}  // namespace toile::prove
