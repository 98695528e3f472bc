// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/flatten/base/outline_targets.h"
#include "core/flatten/base/piece_cloth.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

namespace isometric {
struct EnergyKind;
struct KktModel;
}  // namespace isometric
struct Piece;

/// Data of one flattening for the next one of the same piece, edited (flatten.h). Immutable and
/// shared: copies are free and threads may read the same data.
struct FlatteningMemory {
    /// The disk that is being flattened: the piece, or the piece with its holes filled. Null
    /// between two flattenings.
    std::shared_ptr<const Piece> present{};

    /// The version last flattened by `isometric`, and its points after a converged descent, before
    /// any crossing was undone; null if the descent did not converge.
    std::shared_ptr<const Piece> flattened{};
    std::shared_ptr<const Points2> Q{};
    /// Its points with an outline that does not cross itself: `Q`, or the points after the sides
    /// were moved apart; null if the outline still crosses itself.
    std::shared_ptr<const Points2> simple{};
    double distortion = 0;  ///< of `Q`; 1 if isometric
    /// The end state of that descent: its last model (null for large pieces) and the multipliers of
    /// the boundary lengths.
    std::shared_ptr<const isometric::KktModel> model{};
    std::shared_ptr<const Eigen::VectorXd> multipliers{};
    /// What that descent lowered; the cloth is null if the energy does not read it.
    const isometric::EnergyKind* energy = nullptr;
    PieceClothPointer cloth{};

    /// Figures of the last conformal start of `isometric`, without points.
    FlatPiece start{};
};

/// Exact boundary lengths and the minimum of `options.energy` over boundary and interior, without
/// flipped triangles; see isometric_descent.h, after [SS15]. Starts from `flattenCurvature`, or on
/// a circle if that has flips. The result is never worse than `flattenCurvature`, unless the
/// outline would cross itself and is moved apart (a note says so). `options.quality` sets the
/// accuracy. Cost: one to ten factorisations of size 2 #V; on large pieces as many of a tenth of
/// that size and some conjugate gradients. With the memory of an earlier flattening (or null) it
/// starts from the positions stored there if they are suitable, and stores the data for the next
/// flattening; a memory of another energy or, if the energy reads it, of other cloth is not used.
/// The result is then never worse than these positions, carried over, and is not compared with
/// `flattenCurvature`; its start figures (iterations, gap, flips) are those of the last conformal
/// start.
Result<FlatPiece> flattenIsometric(const Piece& piece, const FlattenOptions& options,
                                   const Progress& progress, FlatteningMemory* memory = nullptr,
                                   const OutlineTargets& targets = {},
                                   const PieceClothPointer& cloth = nullptr);

/// Gives the rims of a piece's holes the lengths they have on the garment: continues the isometric
/// descent with the edges of every rim as further constraints, and without the caps that filled the
/// holes. A patch is sewn to the rim that it was cut from, so both must be equally long. If no such
/// flattening is near (`isNear`), or a rim or the outline would cross itself, `flat` is unchanged
/// and a note (RimsNotKept) states the largest length error of a rim.
/// @param piece  a disk with holes, mm
/// @param flat   the isometric flattening of the piece with its holes filled, without the caps
/// @param targets  of the outline, as it was flattened; rims have their 3D lengths
/// Errors: OutOfMemory, Cancelled. Cost: that of a descent with a good start. Re-entrant.
Result<void> keepRimLengths(const Piece& piece, const FlattenOptions& options, FlatPiece& flat,
                            const Progress& progress, const OutlineTargets& targets = {},
                            const PieceClothPointer& cloth = nullptr);

}  // namespace toile
