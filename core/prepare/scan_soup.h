// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/soup.h"
#include "core/mesh/repair.h"

namespace toile {

/// Triangles made of a file as a file's triangles again, in its unit: with the names of the faces
/// that they come of, and where wanted with their UV map. What has not moved has the file's own
/// numbers; the file's text of them is gone.
/// @param part         in mm; `sourceFace` -1: a face without names
/// @param millimetres  per unit of the file
/// Cost: linear. Pure.
PolygonSoup soupOf(const MeshPart& part, const PolygonSoup& file, double millimetres,
                   bool keepsUvs);

}  // namespace toile
