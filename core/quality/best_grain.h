// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/garment/fabric.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The direction of the warp that suits a flat piece best: the one for which the worn cloth goes
/// least beyond what the fabric allows along warp, weft and bias, by the square of the excess and
/// the worn area. Where directions are alike in that, the one with the least squared strain counts,
/// strain along directions that give way little counting more.
/// @param Q  #V x 2, the unit of the mesh
/// @return radians in [0, pi), anti-clockwise from the x axis of Q; nothing where the strain, or
///         the fabric, is the same in all directions
/// Cost: linear in the triangles, 60 ms for a million; the search over angles works on at most a
/// few thousand groups of triangles strained alike. Pure, thread-safe.
std::optional<double> bestGrain(const MeshArrays& mesh, const Points2& Q, const Fabric& fabric);

/// What bestGrain makes least, for one direction of the warp, summed over all triangles: per area,
/// without dimension. The reference for tests.
double grainCost(const MeshArrays& mesh, const Points2& Q, const Fabric& fabric, double angle);

}  // namespace toile
