// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/wording.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/text.h"

namespace toile {
namespace {

/// Larger numbers are no plausible measure, and their digits would fill the sentence.
constexpr double kWrittenOut = 1e12;

std::string filledIn(const char* pattern, const std::vector<Wording>& arguments) {
    std::string text;
    for (const char* at = pattern; *at != '\0'; ++at) {
        if (*at == '%' && std::isdigit(static_cast<unsigned char>(at[1])) != 0) {
            text += arguments.at(static_cast<std::size_t>(*++at - '1'));
        } else {
            text += *at;
        }
    }
    return text;
}

struct Noun {
    std::string_view noun;
    const char *one, *many;
};

constexpr Noun kNouns[] = {
    {"corner", translatable("1 corner"), translatable("%1 corners")},
    {"crossing", translatable("1 crossing"), translatable("%1 crossings")},
    {"edge", translatable("1 edge"), translatable("%1 edges")},
    {"face", translatable("1 face"), translatable("%1 faces")},
    {"fragment", translatable("1 fragment"), translatable("%1 fragments")},
    {"handle", translatable("1 handle"), translatable("%1 handles")},
    {"hide", translatable("1 hide"), translatable("%1 hides")},
    {"hole", translatable("1 hole"), translatable("%1 holes")},
    {"loop", translatable("1 loop"), translatable("%1 loops")},
    {"opening", translatable("1 opening"), translatable("%1 openings")},
    {"outline vertex", translatable("1 outline vertex"), translatable("%1 outline vertices")},
    {"panel", translatable("1 panel"), translatable("%1 panels")},
    {"sheet", translatable("1 sheet"), translatable("%1 sheets")},
    {"texture coordinate", translatable("1 texture coordinate"),
     translatable("%1 texture coordinates")},
    {"triangle", translatable("1 triangle"), translatable("%1 triangles")},
    {"vertex", translatable("1 vertex"), translatable("%1 vertices")},
};

}  // namespace

Wording::Wording(const char* pattern, std::vector<Wording> arguments)
    : std::string(filledIn(pattern, arguments)),
      pattern_(pattern),
      arguments_(std::move(arguments)) {}

Wording::Wording(double value, int decimals)
    : std::string(fixed(value, decimals)),
      value_(front() == '-' ? value : std::abs(value)),  // never "-0.0"
      decimals_(decimals) {}

Wording& Wording::operator+=(const Wording& more) {
    return more.empty() ? *this : *this = empty() ? more : Wording("%1%2", {*this, more});
}

Wording worded(const char* pattern, std::vector<Wording> arguments) {
    return {pattern, std::move(arguments)};
}

Wording countWording(long long count, std::string_view noun) {
    const auto known = std::ranges::find(kNouns, noun, &Noun::noun);
    return known == std::end(kNouns) ? Wording(counted(count, noun))
           : count == 1              ? worded(known->one)
                                     : worded(known->many, {figure(static_cast<double>(count))});
}

Wording figure(double value, int decimals) {
    return std::abs(value) < kWrittenOut || !std::isfinite(value) ? Wording(value, decimals)
                                                                  : Wording(scientific(value, 2));
}

Wording placeWording(double x, double y, double z) {
    return worded("(%1, %2, %3)", {figure(x, 1), figure(y, 1), figure(z, 1)});
}

}  // namespace toile
