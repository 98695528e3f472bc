// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Takes noise from a surface and keeps its features: bilateral filtering of normals, after which
/// vertices follow them ([ZFAT11], local scheme; vertices by [SRML07]). Triangles whose normals
/// differ by much more than the noise found do not smooth each other, so that folds and hems stay.
/// Rims are smoothed as lines in space in the same way, by their own directions: corners stay, and
/// a rim does not shrink into the surface. Vertices at which a triangle would be turned over or
/// made flat stay where they were.
/// @param mesh      mm; an oriented manifold (`isValidSurface`)
/// @param strength  mm: no vertex moves farther than this; 0: nothing moves
/// @return the positions; those of `mesh` where the work was cancelled
/// Cost: linear. Pure.
Points3 smoothed(const MeshArrays& mesh, double strength, const Progress& progress);

}  // namespace toile
