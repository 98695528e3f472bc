// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/place_words.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "core/base/characters.h"

namespace toile {
namespace {

constexpr std::string_view kBare = "%1, %2, %3", kInBrackets = "(%1, %2, %3)";
constexpr std::string_view kUnit = " mm";

/// The value with all its digits. If it is written in scientific form or as "0.0", the written
/// value, which has no sign in "0.0".
double valueOf(const Wording& figure) {
    double written = std::numeric_limits<double>::quiet_NaN();
    std::from_chars(figure.data(), figure.data() + figure.size(), written);
    return figure.decimals() < 0 || written == 0 ? written : figure.value();
}

std::optional<std::array<double, 3>> placeOf(const Wording& wording) {
    std::array<double, 3> place{};
    const std::string_view pattern = wording.pattern() ? wording.pattern() : "";
    if ((pattern != kInBrackets && pattern != kBare) ||
        wording.arguments().size() != place.size()) {
        return std::nullopt;
    }
    std::ranges::transform(wording.arguments(), place.begin(), valueOf);
    const bool isSomewhere = std::ranges::all_of(place, [](double x) { return std::isfinite(x); });
    return isSomewhere ? std::optional(place) : std::nullopt;
}

void collectPlaces(const Wording& wording, std::string_view after, std::vector<ToldPlace>& places) {
    if (const auto place = placeOf(wording)) {
        places.push_back({wording + std::string(after.starts_with(kUnit) ? kUnit : ""), *place});
        return;
    }
    std::string_view rest = wording.pattern() ? wording.pattern() : "";
    for (std::size_t at = rest.find('%'); at != std::string_view::npos; at = rest.find('%')) {
        rest.remove_prefix(at + 1);
        if (!rest.empty() && std::isdigit(static_cast<unsigned char>(rest.front())) != 0) {
            const auto argument = static_cast<std::size_t>(rest.front() - '1');
            rest.remove_prefix(1);
            collectPlaces(wording.arguments().at(argument), rest, places);
        }
    }
}

}  // namespace

Wording barePlaceWording(double x, double y, double z) {
    return worded("%1, %2, %3", {figure(x, 1), figure(y, 1), figure(z, 1)});
}

std::vector<ToldPlace> placesIn(const Error& error) {
    std::vector<ToldPlace> places;
    collectPlaces(error.detail, {}, places);
    const std::string shown = shownText(error.detail, kMaxOfDetail);  // as `sentence` shows it
    std::size_t from = 0;
    const auto lost = std::ranges::find_if(places, [&](const ToldPlace& place) {
        const std::size_t found = shown.find(place.words, from);
        from = found + place.words.size();
        return found == std::string::npos;
    });
    places.erase(lost, places.end());
    return places;
}

}  // namespace toile
