// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/formats.h"
#include "core/export/piece_meshes.h"
#include "core/reading/mesh_file.h"

namespace toile {

/// Compares meshes as read with those that were to be written: each is there, by name, with its
/// points and its pattern within kReadBackCoordinates, the same triangles, and both sides of each
/// seam as long in the pattern, within kReadBackLengths.
/// Errors: NotReadBack. Cost: linear. Pure.
Result<ReadBack> comparedWithMeshes(const MeshFile& file, const PieceMeshes& meshes);

/// The same of an OBJ file of the whole garment (`writeObj`), whose polygons are the input's.
Result<ReadBack> comparedWithObj(const std::string& obj, const ExportSource& source);

/// What was found, and that both sides of each seam are as long in a pattern as read.
/// @param uv  #V x 2 of each mesh, mm
Result<ReadBack> withSeamsCompared(ReadBack found, const PieceMeshes& meshes,
                                   const std::vector<Points2>& uv);

}  // namespace toile
