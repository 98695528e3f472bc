// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/svg_look.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text.h"
#include "core/reading/svg_numbers.h"

namespace toile {
namespace {

constexpr std::size_t kLongestColour = 100;  // limit, as a class copies it to many elements

/// Calls `take` for each part between marks, trimmed of blanks.
template <class Take>
void forEachPart(std::string_view text, char mark, Take take) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(mark), text.size());
        take(trimmed(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

std::string hexColour(const std::array<double, 3>& parts) {
    constexpr const char* kDigits = "0123456789abcdef";
    std::string text = "#";
    for (const double part : parts) {
        const auto value = static_cast<unsigned>(std::clamp(std::round(part), 0.0, 255.0));
        text += {kDigits[value / 16], kDigits[value % 16]};
    }
    return text;
}

/// Converts "#f00" and "rgb(255, 0, 0)" to "#ff0000"; other words to lower case.
std::string colourText(std::string_view value) {
    std::string text(trimmed(value).substr(0, kLongestColour));
    std::ranges::transform(text, text.begin(), lowered);
    if (text.size() == 4 && text.front() == '#') {
        return {'#', text[1], text[1], text[2], text[2], text[3], text[3]};
    }
    if (!text.starts_with("rgb(")) {
        return text;
    }
    SvgNumbers numbers(std::string_view(text).substr(4));
    std::array<double, 3> parts{};
    for (double& part : parts) {
        const auto number = numbers.number();
        if (!number) {
            return text;
        }
        part = *number;
    }
    return hexColour(parts);
}

}  // namespace

void setSvgProperty(SvgLook& look, std::string_view name, std::string_view value) {
    if (name == "stroke") {
        look.stroke = colourText(value);
    } else if (name == "fill") {
        look.fill = colourText(value);
    } else if (name == "display") {
        look.isShown = look.isShown && trimmed(value) != "none";
    }
}

void setSvgProperties(SvgLook& look, std::string_view declarations) {
    forEachPart(declarations, ';', [&look](std::string_view declaration) {
        const std::size_t colon = declaration.find(':');
        if (colon != std::string_view::npos) {
            setSvgProperty(look, trimmed(declaration.substr(0, colon)),
                           declaration.substr(colon + 1));
        }
    });
}

void setSvgLook(SvgLook& look, const SvgLook& other) {
    look.stroke = other.stroke.empty() ? look.stroke : other.stroke;
    look.fill = other.fill.empty() ? look.fill : other.fill;
    look.isShown = look.isShown && other.isShown;
}

std::map<std::string, SvgLook, std::less<>> svgClasses(std::string_view css) {
    std::map<std::string, SvgLook, std::less<>> classes;
    forEachPart(css, '}', [&classes](std::string_view rule) {
        const std::size_t open = rule.find('{');
        if (open == std::string_view::npos) {
            return;
        }
        SvgLook declared;
        setSvgProperties(declared, rule.substr(open + 1));
        forEachPart(rule.substr(0, open), ',', [&](std::string_view selector) {
            if (selector.starts_with('.') &&
                selector.find_first_of(" .>:[#", 1) == std::string_view::npos) {
                setSvgLook(classes[std::string(selector.substr(1))], declared);
            }
        });
    });
    return classes;
}

}  // namespace toile
