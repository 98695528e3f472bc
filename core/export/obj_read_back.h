// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/export/export_source.h"
#include "core/export/piece_meshes.h"
#include "core/export/read_back.h"

namespace toile {

/// Compares an OBJ file of the whole garment (`writeObj`), whose polygons are the input's, with
/// what it was made from: every point of the pattern within kReadBackCoordinates, both sides of
/// each seam as long, within kReadBackLengths. Errors: NotReadBack. Cost: linear. Pure.
Result<ReadBack> comparedWithObj(const std::string& obj, const ExportSource& source);

/// Adds to `found` that both sides of each seam are as long in a pattern as read.
/// @param uv        #V x 2 of each mesh, mm
/// @param rounding  mm that the format's numbers may cost between two vertices
Result<ReadBack> withSeamsCompared(ReadBack found, const PieceMeshes& meshes,
                                   const std::vector<Points2>& uv, double rounding = 0);

}  // namespace toile
