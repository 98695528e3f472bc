// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/flatten.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

struct KktModel;
struct Piece;

/// What one flattening leaves behind for the next of the same piece, edited (piece_flattener.h).
/// All of it is immutable and shared, so that copies are free and threads may read the same.
struct FlatteningMemory {
    /// The disk now being flattened: the piece, or the piece with its holes filled. Null between
    /// two flattenings.
    std::shared_ptr<const Piece> present{};

    /// The version last flattened by `isometric`, and its points as a descent that converged left
    /// them, before any crossing was undone; null where it did not.
    std::shared_ptr<const Piece> flattened{};
    std::shared_ptr<const Points2> Q{};
    /// Its points with an outline that does not cross itself: the same, or those after it was moved
    /// apart; null where it crosses still.
    std::shared_ptr<const Points2> simple{};
    double distortion = 0;  ///< of `Q`; 1 where isometric
    /// How that descent ended: its last model, null for large pieces, and the pulls of the
    /// boundary edges.
    std::shared_ptr<const KktModel> model{};
    std::shared_ptr<const Eigen::VectorXd> multipliers{};

    /// What the last conformal start of `isometric` had to tell of itself: its figures, no points.
    FlatPiece start{};
};

/// `flatten`, with what is kept from one time to the next, or null.
/// @param memory  `present` is the piece; changed on the way, also where an error comes back
Result<FlatPiece> flattenWith(FlatteningMemory* memory, const Piece& piece,
                              const FlattenOptions& options, const Progress& progress);

}  // namespace toile
