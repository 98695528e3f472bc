// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/prove/fresh_cloth.h"
#include "core/sew/contact.h"

namespace toile::prove {

/// Where the vertices of a garment's pieces lie on cloth in this place, one list per piece. Linear.
std::vector<Points3> sewnPieces(const FreshCloth& fresh, const Points3& X);

/// Fills in what is measured of cloth that has settled: the pieces, gap, strain and free share.
/// @param held  what the cloth lies on, the design or a body
void measureCloth(const FreshCloth& fresh, const Points3& X, const sew::WornSurface& design,
                  const sew::WornSurface& held, Proof& proof);

}  // namespace toile::prove
