// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/render/histogram.h"
#include "app/render/worst_spots.h"
#include "core/garment/fabric.h"

namespace toile {

/// What an overlay says of the whole garment depends on this and on nothing else.
struct OverlayQuestion {
    std::shared_ptr<const Scene> scene{};  ///< may be null
    SheetPlaces places{};                  ///< for the grain
    Fabric fabric{};
    Overlay overlay = Overlay::None;
};

/// True where the answers are the same: places on the sheet do not matter, nor the grain to an
/// overlay that does not follow it.
bool isSameQuestion(const OverlayQuestion& one, const OverlayQuestion& other);

/// The answer: the ends of the colours, who has which value, and where it is worst.
struct OverlayFigures {
    std::shared_ptr<const Scene> scene{};
    Overlay overlay = Overlay::None;
    OverlayScale scale{};
    std::optional<Histogram> histogram{};  ///< none where there are no numbers
    std::vector<WorstSpot> spots{};
};

/// What is known at once: the ends of the colours, without histogram and spots. Cost: none to speak
/// of.
OverlayFigures firstFigures(const OverlayQuestion& question);

/// Pure; cost as `overlayHistogram` and `worstSpots`.
OverlayFigures overlayFigures(const OverlayQuestion& question);

}  // namespace toile
