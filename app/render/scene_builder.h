// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "app/render/scene.h"
#include "core/pipeline/pipeline.h"

namespace toile {

/// Makes the buffers of both views. Pure; meant for a worker thread.
/// @param results  one per piece, or empty before the first flattening: 3D only then
/// @param offsets  mm, one per piece; ignored where `results` is empty
/// @param progress  started here and advanced piece by piece
/// Values of faces and edges are averaged at the vertices, weighted by area and length: at the
/// density of garment meshes this reads as a smooth map instead of noise.
/// After a cancel the scene is incomplete. Cost: linear.
std::shared_ptr<const Scene> buildScene(const Garment& garment, const PieceResults& results,
                                        const std::vector<Eigen::Vector2d>& offsets,
                                        Progress& progress);

}  // namespace toile
