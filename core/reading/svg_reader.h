// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// What a path says of the side of a seam that it is: see writeSvg.
struct SvgSeam {
    std::string name, pair{};
    double length3d = 0;  ///< mm
};

/// A line of an SVG file: a part of a path, or a shape.
struct SvgLine {
    std::string layer{};  ///< label of the innermost layer, else name or id of the outermost group
    std::string id{};     ///< of the element: several parts have it in common
    std::string piece{};  ///< what it or a group about it names as data-piece; else empty
    std::string stroke{}, fill{};    ///< see SvgLook
    std::string text{};              ///< of letters (data-text): this is a part of them
    std::optional<SvgSeam> seam{};   ///< of the side of a seam
    Points2 points = Points2(0, 2);  ///< mm, y up, the page's lower left corner at the origin
    bool closed = false;             ///< as the file says: by Z, or by its kind of shape
};

struct ReadSvg {
    double width = 0, height = 0;  ///< mm; 0 where the file says nothing of its size
    std::vector<SvgLine> lines{};  ///< in the order of the file
};

/// The lines of an SVG file at true scale: paths, polylines, polygons, lines, rectangles, circles
/// and ellipses, below any transforms, curves as points within 0.005 mm of them. Not read: texts,
/// what is not shown, clones (`use`), style sheets but for classes.
/// A file without a size has 96 units to the inch.
/// Errors: MalformedFile (no XML, no SVG, more points than memory should hold). Cost: linear. Pure.
Result<ReadSvg> readSvg(std::string_view bytes);

}  // namespace toile
