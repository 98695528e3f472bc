// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/flatten/base/outline_targets.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

namespace isometric {
struct KktModel;
}
struct Piece;

/// What one flattening leaves behind for the next of the same piece, edited (flatten.h).
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
    /// How that descent ended: its last model, null for large pieces, and the
    /// multipliers of the boundary lengths.
    std::shared_ptr<const isometric::KktModel> model{};
    std::shared_ptr<const Eigen::VectorXd> multipliers{};

    /// What the last conformal start of `isometric` had to tell of itself: its figures, no points.
    FlatPiece start{};
};

/// Exact boundary lengths and the least symmetric Dirichlet energy over boundary and interior,
/// without flipped triangles; isometric_descent.h does the work, [SS15] is the model. Starts from
/// `flattenCurvature`, or on a circle where that has flips, and is never worse than it, but where
/// the outline would cross itself and is moved apart (a note says so). `options.quality` is the
/// dial. Cost: one to ten factorisations of size 2 #V, or on large pieces as many as of a tenth of
/// that and some conjugate gradients.
/// With what is kept of an earlier flattening (or null) it starts from the
/// positions there, if these suit, and keeps what the next can use: then it is never
/// worse than they are, carried over, and is not compared with `flattenCurvature`; of this it tells
/// the figures (iterations, gap, flips) of the last start that was one.
Result<FlatPiece> flattenIsometric(const Piece& piece, const FlattenOptions& options,
                                   const Progress& progress, FlatteningMemory* memory = nullptr,
                                   const OutlineTargets& targets = {});

/// Gives the rims of a piece's holes the lengths they have on the garment: the isometric descent
/// goes on with the edges of every rim among its conditions, and without the caps that filled the
/// holes. A patch is sewn to the rim that it was cut from, so both must be equally long.
/// Where no such flattening is near (`isNear`), or a rim or the outline would cross itself, `flat`
/// stays as it is, and a note (RimsNotKept) tells how far the rim is off that is furthest so.
/// @param piece  a disk with holes, mm
/// @param flat   the isometric flattening of the piece with its holes filled, less the caps
/// @param targets  of the outline, as it was flattened; rims have their 3D lengths
/// Errors: OutOfMemory, Cancelled. Cost: that of a descent with a good start. Re-entrant.
Result<void> keepRimLengths(const Piece& piece, Quality quality, FlatPiece& flat,
                            const Progress& progress, const OutlineTargets& targets = {});

}  // namespace toile
