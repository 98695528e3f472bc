// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/flatten/base/piece_result.h"
#include "core/geometry/placement.h"
#include "core/symmetry/mirror_plane.h"

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

}  // namespace toile
