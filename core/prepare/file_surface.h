// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/io/soup.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A file's faces as triangles, for the eyes of a preparation: positions as the file numbers them.
struct FileSurface {
    MeshArrays mesh;        ///< mm
    std::vector<int> face;  ///< of the soup, per triangle; ascending
};

/// Faces whose positions are not finite are passed over. @param millimetres  per unit of the file
/// Cost: linear. Pure.
FileSurface surfaceOf(const PolygonSoup& soup, double millimetres);

/// The triangles with corners that lie exactly on each other as one vertex: what hangs together in
/// space. Cost: linear on average. Pure.
Triangles weldedFaces(const MeshArrays& mesh);

/// The soup with these faces alone, in their order: positions, names and UV map as they are.
/// @param faces  of the soup, ascending  Cost: linear. Pure.
PolygonSoup withFaces(const PolygonSoup& soup, const std::vector<int>& faces);

/// The soup with every face turned over: its corners in the opposite order. Cost: linear. Pure.
PolygonSoup turnedOver(PolygonSoup soup);

}  // namespace toile
