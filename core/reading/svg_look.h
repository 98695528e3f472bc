// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

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

}  // namespace toile
