// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/garment/records.h"
#include "core/io/soup.h"
#include "core/io/triangulate.h"

namespace toile {

/// The mode to use. For Auto: UV islands if they are nearly isometric and disks (then they are the
/// garment's own flat panels, as CLO and Marvelous Designer write them), else objects, else groups,
/// if the file names at least two, else components. Cost: one pass over the UV edges.
SplitChoice chooseSplit(SplitMode wanted, const PolygonSoup& soup, const Triangulation& triangles);

/// A division of triangles: each triangle's part, numbered by first triangle, and the vertex that
/// each of its corners becomes. Corners of one position in different classes or with different
/// `vt` are different vertices, so that a panel sewn to itself comes open.
struct Division {
    int partCount = 0;
    std::vector<int> partOfTriangle;
    Triangles cornerVertex;       ///< like Triangulation::F, but split vertices have own numbers
    std::vector<int> positionOf;  ///< per vertex: position index in the soup
};

Division splitTriangles(SplitMode mode, const PolygonSoup& soup, const Triangulation& triangles);

/// Number of parts that are disks, by Euler's number: these can lie flat without cuts.
int diskCount(const Division& division);

/// With fewer triangles per part, a division is not a pattern but an atlas of single triangles.
inline constexpr double kMinTrianglesPerPart = 4;

/// How the UV map's lengths relate to 3D: the median of 3D / UV over the edges, and the share of
/// edges whose ratio is within `kIsometricBand` of it. Nothing if there are no usable UVs.
struct UvScale {
    double ratio = 1;
    double closeShare = 0;
};

inline constexpr double kIsometricBand = 0.15;

std::optional<UvScale> measureUvScale(const PolygonSoup& soup, const Triangulation& triangles);

}  // namespace toile
