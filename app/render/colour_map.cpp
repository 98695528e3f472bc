// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/colour_map.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>

#include "core/base/statistics.h"
#include "core/project/piece_settings.h"

namespace toile::app {

namespace {

struct Stop {
    double at;
    Rgb colour;
};

std::uint8_t blend(std::uint8_t a, std::uint8_t b, double t) {
    return static_cast<std::uint8_t>(std::lround(a + (b - a) * t));
}

Rgb blend(Rgb a, Rgb b, double t) {
    return {blend(a.r, b.r, t), blend(a.g, b.g, t), blend(a.b, b.b, t)};
}

ColourMap interpolate(std::span<const Stop> stops) {
    ColourMap map;
    std::size_t segment = 0;
    for (int i = 0; i < kColourMapSize; ++i) {
        const double at = i / double(kColourMapSize - 1);
        while (segment + 2 < stops.size() && at > stops[segment + 1].at) {
            ++segment;
        }
        const Stop &a = stops[segment], &b = stops[segment + 1];
        map[static_cast<std::size_t>(i)] =
            blend(a.colour, b.colour, std::clamp((at - a.at) / (b.at - a.at), 0.0, 1.0));
    }
    return map;
}

/// Share of values inside the bar. Otherwise the few worst triangles at a dart's tip would compress
/// the colours of all others.
constexpr double kShownShare = 0.98;

double roundedUpAmong(std::initializer_list<double> steps, double value) {
    if (!(value > 0) || !std::isfinite(value)) {
        return 1;
    }
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : steps) {
        // The tolerance absorbs rounding, for instance of 2 * 0.1.
        if (value <= step * decade * (1 + 1e-9)) {
            return step * decade;
        }
    }
    return 10 * decade;
}

}  // namespace

const ColourMap& divergingMap() {
    static constexpr Stop kStops[] = {
        {0.00, {24, 62, 128}},   {0.15, {42, 106, 180}},  {0.32, {118, 168, 214}},
        {0.50, {232, 232, 230}}, {0.68, {244, 172, 110}}, {0.85, {222, 102, 40}},
        {1.00, {150, 42, 20}},
    };
    static const ColourMap map = interpolate(kStops);
    return map;
}

const ColourMap& sequentialMap() {
    static constexpr Stop kStops[] = {
        {0.00, {234, 233, 236}}, {0.30, {196, 180, 219}}, {0.60, {146, 112, 184}},
        {0.80, {108, 66, 150}},  {1.00, {62, 20, 102}},
    };
    static const ColourMap map = interpolate(kStops);
    return map;
}

const ColourMap& colourMap(Overlay overlay) {
    return traits(overlay).hasSign ? divergingMap() : sequentialMap();
}

Rgb pieceColour(int piece) {
    static constexpr std::array<Rgb, kHueCount> kHues = {{
        {104, 151, 205},
        {222, 140, 108},
        {130, 178, 143},
        {219, 180, 98},
        {170, 138, 196},
        {92, 173, 173},
        {216, 130, 154},
        {139, 155, 176},
        {166, 172, 98},
        {178, 124, 108},
        {128, 186, 222},
        {199, 163, 133},
    }};
    const Rgb hue = kHues[static_cast<std::size_t>(((piece % kHueCount) + kHueCount) % kHueCount)];
    constexpr Rgb kLight{255, 255, 255}, kDark{30, 34, 44};
    switch ((piece / kHueCount) % 5) {
        case 1:
            return blend(hue, kLight, 0.35);
        case 2:
            return blend(hue, kDark, 0.25);
        case 3:
            return blend(hue, kLight, 0.6);
        case 4:
            return blend(hue, kDark, 0.45);
        default:
            return hue;
    }
}

Rgb neutralColour() {
    return {158, 161, 166};
}

double OverlayScale::position(double value) const {
    return high > low ? std::clamp((value - low) / (high - low), 0.0, 1.0) : 0.5;
}

double OverlayScale::shade(double value) const {
    if (!(low < 0 && high > 0)) {
        return position(value);
    }
    return std::clamp(0.5 + 0.5 * value / (value < 0 ? -low : high), 0.0, 1.0);
}

double OverlayScale::severity(double value) const {
    if (!(low < 0 && high > 0)) {
        return high > low ? (value - low) / (high - low) : 0.0;
    }
    return value < 0 ? value / low : value / high;
}

double roundedUp(double value) {
    return roundedUpAmong({1, 2, 5}, value);
}

double roundedUpClosely(double value) {
    return roundedUpAmong({1, 1.5, 2, 3, 4, 5, 6, 8}, value);
}

OverlayScale robustScale(std::vector<float> values, bool signedValues, double finest) {
    OverlayScale scale;
    scale.low = signedValues ? -finest : 0.0;
    scale.high = finest;
    std::erase_if(values, [](float value) { return !std::isfinite(value); });
    if (values.empty()) {
        return scale;
    }
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    const double lowest = static_cast<double>(*least), highest = static_cast<double>(*largest);

    for (float& value : values) {
        value = std::abs(value);
    }
    const double shown = static_cast<double>(quantileOf(std::move(values), kShownShare));

    const double end = std::max(finest, roundedUpClosely(shown));
    scale.high = end;
    scale.low = signedValues ? -end : 0.0;
    scale.below = lowest < scale.low;
    scale.above = highest > scale.high;
    return scale;
}

}  // namespace toile::app
