// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/render/scene.h"
#include "core/pipeline/pipeline.h"

namespace toile {

/// Makes the buffers of both views. Pure; meant for a worker thread.
/// @param results  one per piece, or empty before the first flattening. Pieces without a flat
///                 result of their own are in 3D only
/// @param progress  started here and advanced piece by piece
/// Values of faces and edges are averaged at the vertices, weighted by area and length: at the
/// density of garment meshes this reads as a smooth map instead of noise.
/// After a cancel the scene is incomplete. Cost: linear.
std::shared_ptr<const Scene> buildScene(const Garment& garment, const PieceResults& results,
                                        Progress& progress);

/// The flat piece in the results, where it is of that very piece; else null.
const FlatPiece* flatPieceOf(const Garment& garment, const PieceResults& results, int piece);

}  // namespace toile
