// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/flatten/base/outline_targets.h"
#include "core/flatten/isometric/isometric.h"

namespace toile {

struct Piece;

/// Flattens one piece. The y axis points where the 3D +y axis points as seen in the plane.
/// Holes are filled for the solve. The lengths of their rims are kept by `isometric` alone, and
/// where it cannot, a note says so.
/// @param piece  a disk, holes aside (no defect), millimetres
/// @param targets  lengths of the outline's edges in the pattern, where not those in 3D; kept as
///                 exactly. Figures of quality are against the garment all the same
/// Notes of crossings come without the cut that helps (diagnose/crossing_cut.h).
/// @errors the piece's own defect, NoClosedOutline, BoundaryNotConverged, FactorisationFailed,
///         NotFinite (coordinates beyond 1e75 mm too), OutOfMemory, Cancelled
/// Cost: the method's. `isometric`: one to ten sparse factorisations of size 2 #V, or
/// on large pieces conjugate gradients; `curvature`: one of size #V. Re-entrant.
Result<FlatPiece> flatten(const Piece& piece, const FlattenOptions& options,
                          const Progress& progress, const OutlineTargets& targets = {});

/// The piece with its outline held at given points, bit for bit, and its interior solved anew:
/// - `isometric`: the least symmetric Dirichlet energy, no flipped triangle; rims of holes keep the
///   lengths that they have in `flat`, and where they cannot, a note says so;
/// - `curvature`, `wang2005`: as the method places it; where that flips a triangle as `isometric`;
/// - others: the interior follows the outline harmonically, and gives way where a triangle would
///   flip.
/// Where `flat` itself has flipped triangles, the new one may have some too; a note counts them.
/// @param flat     the piece's flattening with these options
/// @param outline  #n x 2, mm: of the vertices of piece.boundary, near to where they lie in flat.Q
/// @return `flat` with other points, and notes of crossings, flips and degenerate triangles made
///         anew; all figures stay. `flat` itself where the outline has not moved
/// @errors OutlineNotHeld (a triangle with its corners on the outline would flip, or no way to the
///         outline was found on which none does), FactorisationFailed, NotFinite, OutOfMemory,
///         Cancelled
/// Cost: `isometric`: a factorisation of the interior, and one to three of size 2 #V; where
/// triangles stand in the way one more for each stage. Others: one of the interior. Re-entrant.
Result<FlatPiece> flattenInside(const Piece& piece, const FlatPiece& flat, const Points2& outline,
                                const FlattenOptions& options, const Progress& progress);

/// Flattens one piece again and again while it is edited, and reuses what it can: for `isometric`
/// the positions last found, with the model that led to them. The first flattening, any after a
/// large edit, and those by other methods are that of `flatten`.
///
/// After a small edit `isometric` descends from another start until it meets the same tolerance;
/// where the energy has several minima it stays in the one that the piece already lies in, whatever
/// energy `curvature` would have; of the outline's figures it repeats those of the last start from
/// `curvature`. So the same version reached by other edits may lie a little otherwise, within the
/// tolerance; who wants the very same positions back (undo) keeps them: they are immutable.
///
/// A value: copies share what is kept and go their own ways, so that an edit which parts a piece in
/// two hands both on. Different objects may be used on different threads at a time, one object on
/// one thread. After an error, or a cancel, what was kept stands.
class PieceFlattener {
public:
    /// @param piece  the next version; its `sourceVertex` and `sourceFace` say what has stayed.
    ///               Kept until one takes its place
    /// @param targets  may be others than the last time: the earlier positions are moved to them
    /// Errors: those of `toile::flatten`. Cost: after a small edit fewer steps.
    Result<FlatPiece> flatten(const std::shared_ptr<const Piece>& piece,
                              const FlattenOptions& options, const Progress& progress,
                              const OutlineTargets& targets = {});

    /// About what is kept, pieces aside.
    std::size_t keptBytes() const;
    /// About what will be kept of a piece when it has been flattened, known before.
    static std::size_t expectedBytes(const Piece& piece);

private:
    FlatteningMemory memory_;
};

}  // namespace toile
