// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/tailor/cut_advice.h"

namespace toile {

/// So many of the first advised cuts are solved, to compare with the estimate.
constexpr std::size_t kSolvedAhead = 5;

/// The actual strain with the first `count` advised cuts: makes them and the piece's own cuts,
/// opens closed parts by the shortest cuts, and flattens all parts.
/// @errors  of the first part that cannot be flattened; Cancelled
/// Cost: that of flattening the piece. Re-entrant.
Result<StrainFigures> solvedStrain(const std::shared_ptr<const Piece>& piece,
                                   const std::vector<UserCut>& own, const CutAdvice& advice,
                                   std::size_t count, const FlattenOptions& options,
                                   Progress& progress);

}  // namespace toile
