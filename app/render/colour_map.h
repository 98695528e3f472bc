// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "app/document/view_state.h"
#include "core/quality/piece_quality.h"

namespace toile::app {

struct Rgb {
    std::uint8_t r = 0, g = 0, b = 0;
    bool operator==(const Rgb&) const = default;
};

/// Entries of a colour map, as uploaded and as drawn by the colour bar.
inline constexpr int kColourMapSize = 256;
using ColourMap = std::array<Rgb, kColourMapSize>;

/// Blue (surplus) over light grey (0) to orange-red (stretch). Suitable for common kinds of colour
/// blindness, and symmetric in lightness, so that both signs look equally strong.
const ColourMap& divergingMap();
/// Light grey (0) to deep purple, darkening evenly.
const ColourMap& sequentialMap();
/// The map of a measured overlay.
const ColourMap& colourMap(Overlay overlay);

/// Cloth colour of a piece: calm hues of similar lightness. After kHueCount pieces they repeat in
/// other lightnesses.
Rgb pieceColour(int piece);
/// For pieces that are not flat.
Rgb neutralColour();

/// The range of values of a colour bar, in the displayed unit (percent, degrees, or none).
struct OverlayScale {
    double low = 0, high = 1;
    bool below = false, above = false;  ///< some values lie outside and are clamped
    bool limited = false;               ///< the ends are the fabric's limits

    /// Linear position of a value on the bar, clamped to [0, 1].
    double position(double value) const;
    /// Position of a value in the colour map, clamped to [0, 1]. On a scale with both signs, 0 is
    /// always in the middle and both ends have full colour, even if they differ in size.
    double shade(double value) const;
    /// Ratio of a value to the end on its side: 1 at the end, more beyond it.
    double severity(double value) const;
    /// True beyond an end by more than rounding.
    bool isBeyond(double value) const { return severity(value) > StrainBounds::kSlack; }

    bool operator==(const OverlayScale&) const = default;
};

/// Smallest of 1, 2 or 5 times a power of ten that is at least `value`.
double roundedUp(double value);
/// The same among 1, 1.5, 2, 3, 4, 5, 6 and 8 times a power of ten: closer, still easy to read.
double roundedUpClosely(double value);

/// A scale that shows 98 % of the values, with its end rounded up: symmetric around 0 if
/// `signedValues`, else from 0. It is never smaller than `finest`, so that rounding noise of a
/// perfectly flat piece does not show up as colours.
OverlayScale robustScale(std::vector<float> values, bool signedValues, double finest);

}  // namespace toile::app
