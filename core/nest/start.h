// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/nest/search.h"

// For the sources of this folder only.
namespace toile::nest {

/// A first nest: the largest copies first, each as far to the left as it goes. Valid, unless it was
/// cancelled.
Found firstNest(const Problem& problem, const Progress& progress);

}  // namespace toile::nest
