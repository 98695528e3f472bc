// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/formats/export_source.h"
#include "core/formats/mesh/piece_meshes.h"
#include "core/formats/read_back.h"

namespace toile {

/// Compares an OBJ file of the whole garment (`writeObj`), whose polygons are the input's, with its
/// source: every point of the pattern within kReadBackCoordinates, both sides of each seam in
/// length within kReadBackLengths. Errors: NotReadBack. Cost: linear. Pure.
Result<ReadBack> comparedWithObj(const std::string& obj, const ExportSource& source);

/// Compares the lengths of both sides of each seam in a read pattern; adds this to `found`.
/// @param uv        #V x 2 of each mesh, mm
/// @param rounding  mm of error between two vertices by the format's rounding
Result<ReadBack> withSeamsCompared(ReadBack found, const PieceMeshes& meshes,
                                   const std::vector<Points2>& uv, double rounding = 0);

}  // namespace toile
