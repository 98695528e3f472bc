// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/prove/proof.h"

namespace toile::prove {

/// Mean relative extension of the two sides of a seam from the pattern to the sewn cloth; positive
/// is tension. Ignores sides without length or whose piece is not sewn; 0 if both are ignored.
/// @param pieces  sewn, one per piece of the garment  Cost: linear in the loops. Pure.
double seamStrain(const Garment& garment, const ProvenSeam& seam,
                  const std::vector<ProvenPiece>& pieces);

}  // namespace toile::prove
