// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/nest/search.h"

// For the sources of this folder only.
namespace toile::nest {

/// A first nest, valid: the largest copies first, each as far to the left as it goes.
/// Errors: PageTooSmall naming the item of a copy that finds no room; Cancelled.
Result<Found> firstNest(const Problem& problem, const NestInstance& instance,
                        const Progress& progress);

}  // namespace toile::nest
