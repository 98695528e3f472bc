// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "app/render/overlay_values.h"

namespace toile {

inline constexpr int kHistogramBins = 48;

/// How much of the flat cloth has which value, as parts of its area; all together 1, or 0 where
/// there is no flat cloth.
struct Histogram {
    std::array<double, kHistogramBins> bins{};  ///< even steps from the scale's low to its high end
    double below = 0, above = 0;                ///< beyond the ends

    double beyond() const { return below + above; }
    double tallest() const;
    /// True where there was no cloth to count, as before anything is flat.
    bool isEmpty() const { return !(beyond() > 0 || tallest() > 0); }

    bool operator==(const Histogram&) const = default;
};

/// Of every triangle by itself, whether it is drawn so or smoothed: what lies beyond an end is
/// never averaged away. Pure, thread-safe. Cost: linear, about a tenth of a second at a million
/// triangles.
Histogram overlayHistogram(const Scene& scene, const SheetPlaces& places, Overlay overlay,
                           const OverlayScale& scale);

}  // namespace toile
