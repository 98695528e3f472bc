// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/soup.h"
#include "core/mesh/repair.h"

namespace toile {

/// Converts triangles made from a file back to a soup in its unit: with the names of their original
/// faces, and optionally with their UV map. Unmoved positions keep the file's numbers, but not the
/// file's text of them.
/// @param part         in mm; `sourceFace` -1: a face without names
/// @param millimetres  per unit of the file
/// Cost: linear. Pure.
PolygonSoup soupOf(const MeshPart& part, const PolygonSoup& file, double millimetres,
                   bool keepsUvs);

}  // namespace toile
