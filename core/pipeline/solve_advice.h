// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/tailor/cut_advice.h"

namespace toile {

/// Of the cuts that are advised, so many of the first are solved to be shown beside what is
/// foretold.
constexpr std::size_t kSolvedAhead = 5;

/// What strain there really is with the first `count` of the cuts that were advised: they and the
/// piece's own are made, the shortest open what is still closed, and all parts are flattened.
/// @errors  of the first part that does not become flat; Cancelled
/// Cost: that of flattening the piece. Re-entrant.
Result<StrainFigures> solvedStrain(const std::shared_ptr<const Piece>& piece,
                                   const std::vector<UserCut>& own, const CutAdvice& advice,
                                   std::size_t count, const FlattenOptions& options,
                                   Progress& progress);

}  // namespace toile
