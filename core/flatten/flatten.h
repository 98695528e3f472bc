// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/flatten/base/outline_targets.h"
#include "core/flatten/base/piece_cloth.h"
#include "core/flatten/isometric/isometric.h"

namespace toile {

struct Piece;

/// Flattens one piece. Its y axis follows the 3D +y axis as seen in the plane. Holes are filled for
/// the solve. Only `isometric` keeps the lengths of their rims; if it cannot, it adds a note.
/// @param piece  a disk, apart from holes (no defect), millimetres
/// @param targets  pattern lengths of the outline's edges if they differ from 3D; kept as exactly.
///                 Quality figures are still measured against the garment
/// @param cloth  grain and fabric of the piece, for an energy that reads them (`options.energy`)
/// Notes of crossings do not contain a helpful cut yet (diagnose/crossing_cut.h).
/// @errors the piece's own defect, NoClosedOutline, BoundaryNotConverged, FactorisationFailed,
///         NotFinite (coordinates beyond 1e75 mm too), OutOfMemory, Cancelled
/// Cost: the method's. `isometric`: one to ten sparse factorisations of size 2 #V, or on large
/// pieces conjugate gradients; `curvature`: one of size #V. Re-entrant.
Result<FlatPiece> flatten(const Piece& piece, const FlattenOptions& options,
                          const Progress& progress, const OutlineTargets& targets = {},
                          const PieceClothPointer& cloth = nullptr);

/// The piece with its outline held at given points, bit for bit, and its interior solved again:
/// - `isometric`: minimal `options.energy`, no flipped triangle; rims of holes keep their
///   lengths of `flat`; if they cannot, a note is added;
/// - `curvature`, `wang2005`: as the method places it; if that flips a triangle, like `isometric`;
/// - others: the interior follows the outline harmonically, adjusted where a triangle would flip.
/// If `flat` itself has flipped triangles, the result may have some too; a note counts them.
/// @param flat     the piece's flattening with these options
/// @param outline  #n x 2, mm: vertices of piece.boundary, near to their positions in flat.Q
/// @return `flat` with other points, and new notes of crossings, flips and degenerate triangles;
///         all figures stay. `flat` itself if the outline has not moved
/// @errors OutlineNotHeld (a triangle with all corners on the outline would flip, or no motion to
///         the outline without flips was found), FactorisationFailed, NotFinite, OutOfMemory,
///         Cancelled
/// Cost: `isometric`: a factorisation of the interior, and one to three of size 2 #V; if triangles
/// obstruct the motion, one more for each stage. Others: one of the interior. Re-entrant.
Result<FlatPiece> flattenInside(const Piece& piece, const FlatPiece& flat, const Points2& outline,
                                const FlattenOptions& options, const Progress& progress,
                                const PieceClothPointer& cloth = nullptr);

/// Flattens a piece repeatedly while it is edited, and reuses earlier work: for `isometric` the
/// last positions and their model. The first flattening, any after a large edit, and those by other
/// methods equal that of `flatten`.
///
/// After a small edit `isometric` descends from another start to the same tolerance; if the energy
/// has several minima, it stays in the present one, whatever energy a start from `curvature` would
/// reach; figures of the outline are those of the last start from `curvature`. So different edits
/// that lead to the same version may give slightly different positions, within the tolerance. To
/// restore exact positions (undo), keep the results: they are immutable.
///
/// A value: copies share the memory and diverge, so that an edit that divides a piece passes the
/// memory to both parts. Different objects may be used on different threads, one object on one
/// thread at a time. After an error or a cancel the earlier memory stays.
class PieceFlattener {
public:
    /// @param piece  the next version; its `sourceVertex`, `sourceFace` identify unchanged parts.
    ///               Stored until the next call
    /// @param targets  may differ from the last call: the earlier positions are moved to them
    /// Errors: those of `toile::flatten`. Cost: after a small edit fewer steps.
    Result<FlatPiece> flatten(const std::shared_ptr<const Piece>& piece,
                              const FlattenOptions& options, const Progress& progress,
                              const OutlineTargets& targets = {},
                              const PieceClothPointer& cloth = nullptr);

    /// Approximate size of the memory, pieces aside.
    std::size_t keptBytes() const;
    /// Estimate of the memory for a piece before it is flattened.
    static std::size_t expectedBytes(const Piece& piece);

private:
    FlatteningMemory memory_;
};

}  // namespace toile
