// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/cut/user_cuts.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/symmetry/symmetry.h"

namespace toile {

/// What a person does on one side of a garment, for its other side. Places are carried over in the
/// plane, by the reflection that lays the flat piece over its counterpart (flat_reflection.h), so
/// that both sides of the pattern look alike, however differently the cloth hangs.

/// A mirrored cut whose points all lie within this of the cut itself is no other cut: mm, or a part
/// of the diagonal of the piece's bounding box, whichever is more.
inline constexpr double kSameCut = 1, kSameCutShare = 0.005;

/// A cut whose points are nearly all at most this far from an edge of the piece runs beside it, mm.
inline constexpr double kBesideEdge = 5;

/// The mirror image of a cut, and where it runs: a line on a piece of the garment.
struct CutImage {
    UserCut cut;
    int piece = -1;
    PathPolyline line{};
};

/// The mirror image of a cut that is drawn on a piece of the garment (`findCutOwners`): on the
/// piece's counterpart, or on its other half. Points within the piece go to the place of the flat
/// counterpart where their reflection is, or is nearest to. Points on the outline, and the ends
/// that reach it (`pointsOfCut`), go to the outline: where their segment has a counterpart, to the
/// same share of that; else, and from the rims of holes, to the nearest place of a flat rim. Kind,
/// number of points and `alongEdges` stay; name and id are left empty.
/// None where the piece has no counterpart, one of both is not flat, the cut cannot be made, where
/// the image is the cut itself (`kSameCut`), where it would run beside an edge of the counterpart,
/// that is a seam, a cut or a free edge (`kBesideEdge`) while the cut itself does not, or once it
/// is cancelled.
/// @param results   one per piece, as drawn; null, or of another piece: not flat
/// @param symmetry  of this garment
/// @param cut  its points as the pieces are, mm
/// @param progress  polled from stage to stage and from point to point
/// Cost: linear in the pieces. Pure.
std::optional<CutImage> imageOfCut(const Garment& garment, const PieceResults& results,
                                   const Symmetry& symmetry, const UserCut& cut,
                                   const Progress& progress = Progress());
/// The same without the line.
std::optional<UserCut> mirroredCut(const Garment& garment, const PieceResults& results,
                                   const Symmetry& symmetry, const UserCut& cut,
                                   const Progress& progress = Progress());

/// The direction on a piece's counterpart that mirrors one on the piece, radians in [-pi, pi], in
/// flat coordinates. None where there is no counterpart but itself, or one of both is not flat.
/// Cost: linear in the two pieces. Pure.
std::optional<double> mirroredDirection(const Garment& garment, const PieceResults& results,
                                        const Symmetry& symmetry, int piece, double direction);

}  // namespace toile
