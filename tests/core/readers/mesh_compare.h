// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/formats.h"
#include "core/formats/read_backs.h"
#include "tests/core/readers/mesh_file.h"

namespace toile {

/// Compares meshes as read with those that were to be written: each is there, by name, with its
/// points and its pattern within kReadBackCoordinates, the same triangles, and both sides of each
/// seam as long in the pattern, within kReadBackLengths.
/// Errors: NotReadBack. Cost: linear. Pure.
Result<ReadBack> comparedWithMeshes(const MeshFile& file, const PieceMeshes& meshes);

}  // namespace toile
