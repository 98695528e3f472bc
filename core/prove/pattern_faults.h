// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/prove/proof.h"
#include "core/prove/rest_pattern.h"

namespace toile::prove {

/// Lengths of the two sides of each sewn seam, and mismatches.
struct SeamLengths {
    std::vector<ProvenSeam> seams;
    std::vector<Finding> faults;
};

/// A seam slips if its sides differ by more than kNearlyMm beyond its ease. Its length differs if
/// both sides are shorter, or both longer, than the design's by more than 5 mm and 3 %. Linear.
/// Pure.
SeamLengths seamLengths(const Garment& garment, const RestPattern& pattern);

/// Mean relative extension of the two sides of a seam from the pattern to the sewn cloth; positive
/// is tension. Ignores sides without length or whose piece is not sewn; 0 if both are ignored.
/// @param pieces  sewn, one per piece of the garment  Cost: linear in the loops. Pure.
double seamStrain(const Garment& garment, const ProvenSeam& seam,
                  const std::vector<ProvenPiece>& pieces);

}  // namespace toile::prove
