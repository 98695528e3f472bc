// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/prove/proof.h"

namespace toile::prove {

/// How much longer the two sides of a seam are where they are sewn than in the pattern, their mean;
/// a part of 1, above 0 pulls. Of sides whose piece is not sewn, or has no length: 0.
/// @param pieces  sewn, one per piece of the garment  Cost: linear in the loops. Pure.
double seamStrain(const Garment& garment, const ProvenSeam& seam,
                  const std::vector<ProvenPiece>& pieces);

}  // namespace toile::prove
