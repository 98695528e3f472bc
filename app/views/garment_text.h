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

/// The axis cross shows the garment's orientation; clicking one of its ends turns the garment.

/// Middle of the cross, in the lower left corner of a view.
QPointF axisCrossPlace(const QRect& view);

void paintAxisCross(QPainter& painter, const RenderStyle& style, const QPointF& middle,
                    const Camera3D& camera);

/// The view that a click on one of the ends selects.
std::optional<ViewKey> axisCrossKeyAt(const QPointF& middle, const Camera3D& camera,
                                      const QPointF& at);

/// The text that the garment view paints over the garment, in the window and in pictures.
struct GarmentText {
    const Document& document;
    const Camera3D& camera;
    QRect view;  ///< logical pixels, from 0, 0
    const FlaggedSpots& spots;
    double way = 0;                 ///< position in the morph
    double sewnWay = 0;             ///< as for `GarmentRenderer::paint`
    std::vector<QRectF> covered{};  ///< areas covered by other widgets
};

void paintGarmentText(QPainter& painter, const RenderStyle& style, const GarmentText& text);

}  // namespace toile::app
