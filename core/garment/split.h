// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/soup.h"
#include "core/io/triangulate.h"

namespace toile {

/// How a file is divided into pieces. In every mode a piece is connected: a class with several
/// components gives several pieces.
enum class SplitMode {
    Auto,        ///< by the file's contents; `SplitChoice::reason` explains it
    Components,  ///< connected by shared vertices
    Objects,     ///< OBJ `o`
    Groups,      ///< OBJ `g`
    Materials,   ///< OBJ `usemtl`
    Uv,          ///< islands of the UV map, by shared `vt` index, never by position
    Seams,       ///< only along the user's cuts: like components, ignoring names
};

/// A mode other than Auto, and why it was chosen if the user stated none.
struct SplitChoice {
    SplitMode mode = SplitMode::Components;
    Wording reason;  ///< for display; empty if the mode was stated
};

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

/// "auto", "components", ...: the words of the command line.
std::string_view name(SplitMode mode);
std::optional<SplitMode> parseSplitMode(std::string_view text);

}  // namespace toile
