// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/overlay_figures.h"

#include <algorithm>

namespace toile {

bool isSameQuestion(const OverlayQuestion& one, const OverlayQuestion& other) {
    if (one.scene != other.scene || one.overlay != other.overlay || !(one.fabric == other.fabric)) {
        return false;
    }
    const auto sameGrain = [](const SheetPlace& a, const SheetPlace& b) -> bool {
        return a.grain == b.grain;
    };
    return !followsGrain(one.overlay) || std::ranges::equal(one.places, other.places, sameGrain);
}

OverlayFigures firstFigures(const OverlayQuestion& question) {
    OverlayFigures figures;
    figures.scene = question.scene;
    figures.overlay = question.overlay;
    if (question.scene) {
        figures.scale = overlayScale(*question.scene, question.overlay, question.fabric);
    }
    return figures;
}

OverlayFigures overlayFigures(const OverlayQuestion& question) {
    OverlayFigures figures = firstFigures(question);
    if (question.scene && isMeasured(question.overlay)) {
        figures.histogram =
            overlayHistogram(*question.scene, question.places, question.overlay, figures.scale);
        figures.spots =
            worstSpots(*question.scene, question.places, question.overlay, figures.scale);
    }
    return figures;
}

}  // namespace toile
