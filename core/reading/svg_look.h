// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace toile {

/// How an element of an SVG file is shown, as far as readers ask.
struct SvgLook {
    std::string stroke{}, fill{};  ///< "#rrggbb", "none", or as the file says it; empty: unsaid
    bool isShown = true;           ///< false below "display: none" too
};

/// Changes a look by one property; what else there is changes nothing.
void setSvgProperty(SvgLook& look, std::string_view name, std::string_view value);

/// Changes a look by declarations, "stroke:#f00;fill:none".
void setSvgProperties(SvgLook& look, std::string_view declarations);

/// Changes a look by what another says.
void setSvgLook(SvgLook& look, const SvgLook& other);
/// What each class declares in the text of a style element: of its rules those whose
/// selectors are single classes (".st0,.st1{stroke:#f00}"). Cost: linear.
std::map<std::string, SvgLook, std::less<>> svgClasses(std::string_view css);

}  // namespace toile
