// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>

#include "app/render/camera.h"
#include "app/views/flags.h"

namespace toile::app {

/// What the pattern view writes over the sheet, in the window and in pictures alike: caption, grain
/// arrows, names, flags, scale bar and rulers.
struct PatternText {
    const Document& document;
    const SheetPlaces& places;
    const Camera2D& camera;
    QRect view;  ///< logical pixels, from 0, 0
    const FlaggedSpots& spots;
    bool strongGrain = false;  ///< while the grain is what is being worked on
};

void paintPatternText(QPainter& painter, const RenderStyle& style, const PatternText& text);

}  // namespace toile::app
