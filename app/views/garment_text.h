// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>

#include "app/render/camera_3d.h"
#include "app/views/spot_flags.h"

namespace toile {

/// What the garment view writes over the garment, in the window and in pictures alike.
struct GarmentText {
    const Document& document;
    const Camera3D& camera;
    QRect view;  ///< logical pixels, from 0, 0
    const FlaggedSpots& spots;
    double way = 0;                 ///< of the morph
    std::vector<QRectF> covered{};  ///< by what else lies over the view
};

void paintGarmentText(QPainter& painter, const RenderStyle& style, const GarmentText& text);

}  // namespace toile
