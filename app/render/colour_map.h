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

/// Entries of a colour map as uploaded and as drawn by the colour bar.
inline constexpr int kColourMapSize = 256;
using ColourMap = std::array<Rgb, kColourMapSize>;

/// Blue (surplus) over light grey (0) to orange-red (stretch): told apart by all common kinds of
/// colour blindness, and symmetric in lightness, so that neither side looks worse than the other.
const ColourMap& divergingMap();
/// Light grey (0) to deep purple, darkening evenly.
const ColourMap& sequentialMap();
/// The map of a measured overlay.
const ColourMap& colourMap(Overlay overlay);

/// Cloth colour of a piece: calm hues of like lightness that repeat, lighter and darker, after
/// kHueCount.
Rgb pieceColour(int piece);
/// Pieces that are not flat.
Rgb neutralColour();

/// The span of values a colour bar covers, in the unit shown (percent, degrees, or none).
struct OverlayScale {
    double low = 0, high = 1;
    bool below = false, above = false;  ///< some values lie outside and are clamped
    bool limited = false;               ///< the ends are the limits of the fabric

    /// Place of a value on the bar, in even steps, clamped to [0, 1].
    double position(double value) const;
    /// Place of a value in the colour map, clamped to [0, 1]: where the scale has two sides, 0 is
    /// always in the middle and either end is full colour, however unlike the two ends are.
    double shade(double value) const;
    /// How near a value is to the end on its side: 1 at the end, more beyond it.
    double severity(double value) const;
    /// True beyond an end by more than rounding.
    bool isBeyond(double value) const { return severity(value) > StrainBounds::kSlack; }

    bool operator==(const OverlayScale&) const = default;
};

/// Smallest of 1, 2 or 5 times a power of ten that is at least `value`.
double roundedUp(double value);
/// The same among 1, 1.5, 2, 3, 4, 5, 6 and 8 times a power of ten: closer, still easy to read.
double roundedUpClosely(double value);

/// A scale that shows 98 % of the values: symmetric about 0 where `signedValues`, else from 0, its
/// end rounded up, and never finer than `finest`, so that rounding noise of a perfectly flat piece
/// is not blown up into colours.
OverlayScale robustScale(std::vector<float> values, bool signedValues, double finest);

}  // namespace toile::app
