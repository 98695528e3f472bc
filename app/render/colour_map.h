// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "app/document/view_state.h"

namespace toile {

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

/// Cloth colour of a piece: calm hues of like lightness that repeat, lighter and darker, after 12.
Rgb pieceColour(int piece);
/// Pieces that are not flat.
Rgb neutralColour();

}  // namespace toile
