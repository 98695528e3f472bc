// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/prove/rest_pattern.h"

namespace toile::prove {

/// How long the two sides of each seam are that is sewn, and what does not fit.
struct SeamLengths {
    std::vector<ProvenSeam> seams;
    std::vector<ProofFault> faults;
};

/// A seam slips where its sides differ by more than kNearlyMm beyond its ease; its length differs
/// where both of them are shorter, or longer, than the design's by more than 5 mm and 3 %.
/// Linear. Pure.
SeamLengths seamLengths(const Garment& garment, const RestPattern& pattern);

}  // namespace toile::prove
