// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/garment/piece.h"
#include "core/io/soup.h"

namespace toile {

/// Per edge of a piece: whether its two triangles have other materials, groups or objects in the
/// file, or other points of its UV map there. Who made the mesh meant such lines as borders.
/// @param soup  that the piece was divided from
/// @return empty where there is none, or where there are too many to be seams: a UV map of single
///         triangles
/// Cost: linear. Pure.
std::vector<char> fileBorders(const Piece& piece, const PolygonSoup& soup);

}  // namespace toile
