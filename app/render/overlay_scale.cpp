// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/overlay_scale.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace toile {

namespace {

/// Share of the values that lies within the bar: the few worst triangles at a dart's tip would
/// otherwise wash out everything else.
constexpr double kShownShare = 0.98;

double roundedUpAmong(std::initializer_list<double> steps, double value) {
    if (!(value > 0) || !std::isfinite(value)) {
        return 1;
    }
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : steps) {
        // The slack keeps 0.2 at 0.2 although 2 * 0.1 may come out a digit below it.
        if (value <= step * decade * (1 + 1e-9)) {
            return step * decade;
        }
    }
    return 10 * decade;
}

}  // namespace

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
    const auto rank =
        static_cast<std::ptrdiff_t>(kShownShare * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    const double shown = static_cast<double>(values[static_cast<std::size_t>(rank)]);

    const double end = std::max(finest, roundedUpClosely(shown));
    scale.high = end;
    scale.low = signedValues ? -end : 0.0;
    scale.below = lowest < scale.low;
    scale.above = highest > scale.high;
    return scale;
}

}  // namespace toile
