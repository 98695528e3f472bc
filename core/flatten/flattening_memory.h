// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/flatten/flatten.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

class InteriorSystem;
struct Piece;

/// What one flattening leaves behind for the next of the same piece, edited (piece_flattener.h).
/// All of it is immutable and shared, so that copies are free and threads may read the same.
struct FlatteningMemory {
    /// The disk now being flattened: the piece, or the piece with its holes filled. Null between
    /// two flattenings.
    std::shared_ptr<const Piece> present{};

    /// The version whose interior was factorised, and the factor.
    std::shared_ptr<const Piece> factorised{};
    std::shared_ptr<const InteriorSystem> interior{};

    /// The version last flattened by `isometric`, and its points as a descent that converged left
    /// them, before any crossing was undone; null where it did not.
    std::shared_ptr<const Piece> flattened{};
    std::shared_ptr<const Points2> Q{};
    double distortion = 0;  ///< of these points; 1 where isometric

    /// What the last conformal start of `isometric` had to tell of itself: its figures, no points.
    FlatPiece start{};
};

}  // namespace toile
