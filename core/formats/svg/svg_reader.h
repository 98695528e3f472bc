// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Visible style of an SVG element, as far as readers need it.
struct SvgLook {
    std::string stroke{}, fill{};  ///< "#rrggbb", "none", or the file's text; empty: not set
    bool isShown = true;           ///< also false inside "display: none"
};

/// Sets one property of a look; other properties are ignored.
void setSvgProperty(SvgLook& look, std::string_view name, std::string_view value);

/// Applies declarations such as "stroke:#f00;fill:none" to a look.
void setSvgProperties(SvgLook& look, std::string_view declarations);

/// Applies the properties set in another look.
void setSvgLook(SvgLook& look, const SvgLook& other);
/// Declarations of each class in the text of a style element. Reads only rules whose selectors are
/// single classes (".st0,.st1{stroke:#f00}"). Cost: linear.
std::map<std::string, SvgLook, std::less<>> svgClasses(std::string_view css);

/// Seam data of a path that is a side of a seam: see writeSvg.
struct SvgSeam {
    std::string name, pair{};
    double length3d = 0;  ///< mm
};

/// A line of an SVG file: a part of a path, or a shape.
struct SvgLine {
    std::string layer{};  ///< label of the innermost layer, else name or id of the outermost group
    std::string id{};     ///< of the element; its parts share it
    std::string label{};  ///< its label or title, else that of the innermost group with one
    std::string piece{};  ///< data-piece of the element or an enclosing group
    std::string stroke{}, fill{};    ///< see SvgLook
    std::string text{};              ///< data-text, if the line is part of letters
    std::optional<SvgSeam> seam{};   ///< if the line is a side of a seam
    Points2 points = Points2(0, 2);  ///< mm, y up, the page's lower left corner at the origin
    bool closed = false;             ///< by Z, or by its kind of shape
};

struct ReadSvg {
    double width = 0, height = 0;  ///< mm; 0 if the file does not give its size
    std::vector<SvgLine> lines{};  ///< in the order of the file
};

/// The lines of an SVG file at true scale: paths, polylines, polygons, lines, rectangles, circles
/// and ellipses, with all transforms applied, curves as points within 0.005 mm of them. Ignores
/// texts, hidden elements, clones (`use`) and style sheets except for classes.
/// A file without a size has 96 units to the inch.
/// Errors: MalformedFile (no XML, no SVG, decimal commas, too many points for memory). Cost:
/// linear. Pure.
Result<ReadSvg> readSvg(std::string_view bytes);

}  // namespace toile
