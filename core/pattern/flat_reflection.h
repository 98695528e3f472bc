// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/flatten/base/piece_result.h"
#include "core/geometry/placement.h"
#include "core/symmetry/mirror_plane.h"

namespace toile {

/// The reflection that lays a flat piece best over the flat piece that mirrors it, or over itself,
/// in the least-squares sense. It starts from vertices and the points nearest to their mirror
/// images on the garment; as cloth hangs these are often centimetres beside what they mirror, so
/// from there outline and outline are laid over each other by turns, each with the nearest places
/// of the other. Where the two are drawn as exact mirror images (`MirroredOutline`) it is that of
/// the drawn lines. For the two in the other order it is the inverse, and of a piece with itself a
/// reflection in a line.
/// Precondition: both are flat.
/// Cost: linear in the two, O(log #F) for each of at most 800 vertices, and 40 rounds of 400 times
/// the outlines' edges: some hundredths of a second. Pure.
Placement reflectionBetween(const PieceResult& piece, const PieceResult& counterpart,
                            const MirrorPlane& plane);

}  // namespace toile
