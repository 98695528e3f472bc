// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/io/soup.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The soup's polygons as triangles over the same positions.
struct Triangulation {
    Triangles F;                  ///< position indices, in face order
    std::vector<int> sourceFace;  ///< per triangle: the soup face it comes from
    Problems problems;            ///< DegenerateFaceRecord, NonFinitePosition, PolygonNotSimple
};

/// Divides polygons by ear clipping in the plane of their Newell normal (a concave polygon keeps
/// its shape; a fan would not). A quad is divided by the diagonal inside it, the shorter one if
/// both are. Faces that repeat a corner or use a non-finite position are dropped and listed; a
/// polygon that crosses itself becomes a fan and is listed. Triangles are unchanged.
/// Polygons of more than 4000 corners become fans and are listed too.
/// Cost: linear for triangles and quads, quadratic in the corners of one larger polygon.
Triangulation triangulate(const PolygonSoup& soup, const std::string& name);

}  // namespace toile
