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

/// The text that the pattern view paints over the sheet, in the window and in pictures: caption,
/// grain arrows, names, callouts, reference distances, scale bar and rulers.
struct PatternText {
    const Document& document;
    const SheetPlaces& places;
    const Camera2D& camera;
    QRect view;  ///< logical pixels, from 0, 0
    const FlaggedSpots& spots;
    const ReferenceGaps& gaps;
    KeptNames& names;               ///< of this view
    std::vector<QRectF> covered{};  ///< areas covered by other widgets
    bool strongGrain = false;       ///< while grain is being edited
    bool isElse = false;            ///< something else explains why no piece is flat
};

void paintPatternText(QPainter& painter, const RenderStyle& style, const PatternText& text);

}  // namespace toile::app
