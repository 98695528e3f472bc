// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/base/progress.h"
#include "core/compare/comparison.h"

namespace toile {

/// Flattens and measures every piece by every method, one method after the other, pieces side by
/// side. A piece that fails under one method leaves the others alone.
/// @param methods  in the order wanted  @param options  `method` is not looked at
/// @return after a cancel the unfinished pieces carry ErrorCode::Cancelled
/// Cost: `flattenGarment` once per method; all flat pieces are kept. Re-entrant.
Comparison compareMethods(const Garment& garment, std::span<const Method> methods,
                          const FlattenOptions& options, Progress& progress);

}  // namespace toile
