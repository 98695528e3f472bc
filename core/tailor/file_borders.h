// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/garment/piece.h"
#include "core/io/soup.h"

namespace toile {

/// Per edge of a piece: whether its two triangles have different materials, groups or objects in
/// the file, or different UV points. The author of the mesh intended such lines as borders.
/// @param soup  the polygons that the piece was divided from
/// @return empty if there are no borders, or too many to be seams: a UV map of single triangles
/// Cost: linear. Pure.
std::vector<char> fileBorders(const Piece& piece, const PolygonSoup& soup);

}  // namespace toile
