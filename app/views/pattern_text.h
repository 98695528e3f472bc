// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>
#include <QRectF>
#include <vector>

#include "app/render/camera.h"
#include "app/views/callouts.h"
#include "app/views/name_labels.h"
#include "app/views/reference_gaps.h"

namespace toile::app {

/// What the pattern view writes over the sheet, in the window and in pictures alike: caption, grain
/// arrows, names, callouts, distances from the reference, scale bar and rulers.
struct PatternText {
    const Document& document;
    const SheetPlaces& places;
    const Camera2D& camera;
    QRect view;  ///< logical pixels, from 0, 0
    const FlaggedSpots& spots;
    const ReferenceGaps& gaps;
    KeptNames& names;               ///< of this view
    std::vector<QRectF> covered{};  ///< by what else lies over the view
    bool strongGrain = false;       ///< while the grain is what is being worked on
    bool isElse = false;            ///< where no piece is flat, something else says why
};

void paintPatternText(QPainter& painter, const RenderStyle& style, const PatternText& text);

}  // namespace toile::app
