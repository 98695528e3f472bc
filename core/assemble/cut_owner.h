// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cut/user_cuts.h"
#include "core/garment/piece.h"

namespace toile {

/// Assigns the user's cuts to pieces: every cut goes to the piece whose surface is closest to its
/// points, by the sum of distances, the first of equals.
struct CutOwners {
    std::vector<std::vector<UserCut>> cutsOf;  ///< per piece, in the order given
    Problems problems;  ///< cuts with a point far from every piece, or without any finite point
};

/// A point farther from its piece than this fraction of the garment's diagonal indicates a wrong
/// unit or a wrong garment.
inline constexpr double kFarFromSurface = 0.1;

/// Cost: a tree of boxes per piece, and one question per piece and point; nothing without cuts.
/// @param progress  polled from piece to piece
CutOwners findCutOwners(const Pieces& pieces, const std::vector<UserCut>& cuts,
                        const Progress& progress);

}  // namespace toile
