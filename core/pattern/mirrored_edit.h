// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/cut/user_cuts.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/geometry/placement.h"
#include "core/symmetry/mirror_plane.h"
#include "core/symmetry/symmetry.h"

namespace toile {

/// The reflection that best lays a flat piece over its mirrored flat piece, or over itself, in the
/// least-squares sense. It starts from vertices and the points nearest to their mirror images on
/// the garment. Because cloth hangs, these are often off by centimetres, so the outlines are then
/// laid over each other alternately, each with the nearest places of the other. If the two are
/// drawn as exact mirror images (`MirroredOutline`), it is the reflection of the drawn lines.
/// Swapping the pieces gives the inverse; a piece with itself gives a reflection in a line.
/// Precondition: both are flat.
/// Cost: linear in the two, O(log #F) for each of at most 800 vertices, and 40 rounds of 400 times
/// the outlines' edges: some hundredths of a second. Pure.
Placement reflectionBetween(const PieceResult& piece, const PieceResult& counterpart,
                            const MirrorPlane& plane);

/// Repeats an edit of one side of a garment on the other side. Places are transferred in the plane,
/// by the reflection that lays the flat piece over its counterpart (flat_reflection.h), so that
/// both sides of the pattern look alike, however differently the cloth hangs.

/// A mirrored cut counts as the cut itself if all its points lie within this distance of it: mm, or
/// a part of the diagonal of the piece's bounding box, whichever is more.
inline constexpr double kSameCut = 1, kSameCutShare = 0.005;

/// A cut runs along an edge of the piece if nearly all its points are this near to the edge, mm.
inline constexpr double kBesideEdge = 5;

/// The mirror image of a cut, and its path: a line on a piece of the garment.
struct CutImage {
    UserCut cut;
    int piece = -1;
    PathPolyline line{};
};

/// The mirror image of a cut that is drawn on a piece of the garment (`findCutOwners`): on the
/// piece's counterpart, or on its other half. Points inside the piece go to the place of the flat
/// counterpart nearest to their reflection. Points on the outline, and the ends that reach it
/// (`pointsOfCut`), go to the outline: to the same share of the segment's counterpart; without one,
/// and from rims of holes, to the nearest place of a flat rim. Kind, number of points and
/// `alongEdges` stay; name and id are empty.
/// Nothing if the piece has no counterpart, if one of both is not flat, if the cut cannot be made,
/// if the image is the cut itself (`kSameCut`), if it would run along an edge of the counterpart
/// (seam, cut or free edge; `kBesideEdge`) while the cut itself does not, or after a cancel.
/// @param results   one per piece, as drawn; null or of another piece: not flat
/// @param symmetry  of this garment
/// @param cut  its points in coordinates of the pieces, mm
/// @param progress  polled between stages and between points
/// Cost: linear in the pieces. Pure.
std::optional<CutImage> imageOfCut(const Garment& garment, const PieceResults& results,
                                   const Symmetry& symmetry, const UserCut& cut,
                                   const Progress& progress = Progress());
/// The same without the line.
std::optional<UserCut> mirroredCut(const Garment& garment, const PieceResults& results,
                                   const Symmetry& symmetry, const UserCut& cut,
                                   const Progress& progress = Progress());

/// The direction on a piece's counterpart that mirrors a direction on the piece, radians in [-pi,
/// pi], in flat coordinates. Nothing if there is no other counterpart, or one of both is not flat.
/// Cost: linear in the two pieces. Pure.
std::optional<double> mirroredDirection(const Garment& garment, const PieceResults& results,
                                        const Symmetry& symmetry, int piece, double direction);

}  // namespace toile
