// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/io/soup.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A file's faces as triangles, for the preparation: positions are numbered as in the file.
struct FileSurface {
    MeshArrays mesh;        ///< mm
    std::vector<int> face;  ///< of the soup, per triangle; ascending
};

/// Faces with non-finite positions are skipped. @param millimetres  per unit of the file
/// Cost: linear. Pure.
FileSurface surfaceOf(const PolygonSoup& soup, double millimetres);

/// The triangles with coinciding corners merged into one vertex, to find parts connected in space.
/// Cost: linear on average. Pure.
Triangles weldedFaces(const MeshArrays& mesh);

/// The soup with only these faces, in their order: positions, names and UV map unchanged.
/// @param faces  of the soup, ascending  Cost: linear. Pure.
PolygonSoup withFaces(const PolygonSoup& soup, const std::vector<int>& faces);

/// The soup with every face flipped: its corners in the opposite order. Cost: linear. Pure.
PolygonSoup turnedOver(PolygonSoup soup);

/// Removes faces that coincide with others, like those of double-sided meshes. Cost: n log n. Pure.
FileSurface withoutDoubles(const FileSurface& file);

/// The parts of a surface connected by vertices.
struct SurfaceParts {
    std::vector<int> of;         ///< per triangle, numbered by first triangle
    std::vector<double> area{};  ///< per part, mm2
    std::vector<char> isClosed{};
    double total = 0;  ///< mm2

    /// Share of the area in closed parts.
    double closedShare() const;
};

/// @param mesh  mm  Cost: n log n. Pure.
SurfaceParts partsOf(const MeshArrays& mesh);

}  // namespace toile
