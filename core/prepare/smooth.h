// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Removes noise from a surface but keeps its features: bilateral filtering of normals, after which
/// vertices follow them ([ZFAT11], local scheme; vertices by [SRML07]). Triangles whose normals
/// differ by much more than the detected noise do not smooth each other, so that folds and hems
/// stay. Rims are smoothed in the same way as lines in space, by their own directions: corners
/// stay, and a rim does not shrink into the surface. Vertices at which a triangle would flip or
/// become flat stay unchanged.
/// @param mesh      mm; an oriented manifold (`isValidSurface`)
/// @param strength  mm: maximum move of a vertex; 0: nothing moves
/// @return the positions; those of `mesh` if the work was cancelled
/// Cost: linear. Pure.
Points3 smoothed(const MeshArrays& mesh, double strength, const Progress& progress);

}  // namespace toile
