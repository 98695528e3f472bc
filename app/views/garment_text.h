// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRect>
#include <optional>

#include "app/render/camera.h"
#include "app/views/callouts.h"
#include "app/views/navigation.h"

class QPainter;

namespace toile::app {

struct RenderStyle;

/// A small cross that tells how the garment is turned, and turns it when its ends are clicked.

/// Its middle, in the lower left corner of a view.
QPointF axisCrossPlace(const QRect& view);

void paintAxisCross(QPainter& painter, const RenderStyle& style, const QPointF& middle,
                    const Camera3D& camera);

/// What a click on one of the ends asks for.
std::optional<ViewKey> axisCrossKeyAt(const QPointF& middle, const Camera3D& camera,
                                      const QPointF& at);

/// What the garment view writes over the garment, in the window and in pictures alike.
struct GarmentText {
    const Document& document;
    const Camera3D& camera;
    QRect view;  ///< logical pixels, from 0, 0
    const FlaggedSpots& spots;
    double way = 0;                 ///< of the morph
    double sewnWay = 0;             ///< as for `GarmentRenderer::paint`
    std::vector<QRectF> covered{};  ///< by what else lies over the view
};

void paintGarmentText(QPainter& painter, const RenderStyle& style, const GarmentText& text);

}  // namespace toile::app
