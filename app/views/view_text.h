// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRect>
#include <QString>

class QPainter;

namespace toile {

struct RenderStyle;

/// Writing over the views. Logical pixels.

/// What the view shows, in its upper left corner; `note` follows in smaller, fainter letters.
void paintCaption(QPainter& painter, const RenderStyle& style, const QString& title,
                  const QString& note);

/// A name on a rounded plate that keeps it legible on any cloth; shortened in its middle (ends tell
/// "left" from "right") to `room` pixels, left
/// out where there is no room for a few letters.
void paintPlate(QPainter& painter, const RenderStyle& style, const QPointF& middle, double room,
                const QString& text, bool selected);

/// A bar of a round length with its measure, in the lower left corner.
void paintScaleBar(QPainter& painter, const RenderStyle& style, const QRect& view,
                   double pixelsPerMillimetre);

/// Round length for a scale bar of about `pixels`, and its text ("5 cm", "2 mm", "1 m").
struct ScaleBar {
    double millimetres;
    QString text;
};

ScaleBar scaleBarFor(double pixels, double pixelsPerMillimetre);

}  // namespace toile
