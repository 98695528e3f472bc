// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/prove/rest_pattern.h"

namespace toile::prove {

/// Lengths of the two sides of each sewn seam, and mismatches.
struct SeamLengths {
    std::vector<ProvenSeam> seams;
    std::vector<ProofFault> faults;
};

/// A seam slips if its sides differ by more than kNearlyMm beyond its ease. Its length differs if
/// both sides are shorter, or both longer, than the design's by more than 5 mm and 3 %. Linear.
/// Pure.
SeamLengths seamLengths(const Garment& garment, const RestPattern& pattern);

}  // namespace toile::prove
