// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/svg_look.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text.h"
#include "core/reading/svg_numbers.h"

namespace toile {
namespace {

constexpr std::string_view kCssBlanks = " \t\r\n\f";

std::string_view withoutBlanks(std::string_view text) {
    const std::size_t from = text.find_first_not_of(kCssBlanks);
    return from == std::string_view::npos
               ? std::string_view()
               : text.substr(from, text.find_last_not_of(kCssBlanks) - from + 1);
}

/// Calls for each part between marks, without the blanks about it.
template <class Take>
void forEachPart(std::string_view text, char mark, Take take) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(mark), text.size());
        take(withoutBlanks(text.substr(0, end)));
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

/// "#f00" and "rgb(255, 0, 0)" as "#ff0000"; other words in lower case.
std::string colourText(std::string_view value) {
    std::string text(withoutBlanks(value));
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
        look.isShown = look.isShown && withoutBlanks(value) != "none";
    }
}

void setSvgProperties(SvgLook& look, std::string_view declarations) {
    forEachPart(declarations, ';', [&look](std::string_view declaration) {
        const std::size_t colon = declaration.find(':');
        if (colon != std::string_view::npos) {
            setSvgProperty(look, withoutBlanks(declaration.substr(0, colon)),
                           declaration.substr(colon + 1));
        }
    });
}

std::map<std::string, std::string, std::less<>> svgClasses(std::string_view css) {
    std::map<std::string, std::string, std::less<>> classes;
    forEachPart(css, '}', [&classes](std::string_view rule) {
        const std::size_t open = rule.find('{');
        if (open == std::string_view::npos) {
            return;
        }
        const std::string_view declarations = rule.substr(open + 1);
        forEachPart(rule.substr(0, open), ',', [&](std::string_view selector) {
            if (selector.starts_with('.') &&
                selector.find_first_of(" .>:[#", 1) == std::string_view::npos) {
                std::string& all = classes[std::string(selector.substr(1))];
                all += ';';
                all += declarations;
            }
        });
    });
    return classes;
}

}  // namespace toile
