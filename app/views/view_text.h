// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QLineF>
#include <QOpenGLPaintDevice>
#include <QPainter>
#include <QPointF>
#include <QRect>
#include <QString>

class QPainter;
class QWidget;

namespace toile::app {

struct RenderStyle;

/// Writing over the views. Logical pixels.

/// What the view shows, in its upper left corner; `note` follows in smaller, fainter letters.
/// @param corner   of the part of the view that is free for it
/// @param onLabel  where cloth lies under it: on a label, as other words over the cloth
void paintCaption(QPainter& painter, const RenderStyle& style, const QPointF& corner,
                  const QString& title, const QString& note, bool onLabel);
/// What a caption and its box take.
QRectF captionBox(const QFont& font, const QPointF& corner, const QString& title,
                  const QString& note);

/// Whether something holds at any of many points of a part of the view, some pixels apart.
template <class Holds>
bool anyPointIn(const QRectF& part, const Holds& holds) {
    constexpr int kAcross = 24, kDown = 4;
    for (int i = 0; i <= kAcross; ++i) {
        for (int k = 0; k <= kDown; ++k) {
            if (holds(part.left() + i * part.width() / kAcross,
                      part.top() + k * part.height() / kDown)) {
                return true;
            }
        }
    }
    return false;
}

/// Whether any of a line lies in a box.
bool crosses(const QLineF& line, const QRectF& box);

/// A label: a name in a rounded box that keeps it legible on any cloth.
/// @param box   as large as `labelSize` says
/// @param size  of the usual letters; smaller ones have less room around them, too
void paintLabel(QPainter& painter, const RenderStyle& style, const QRectF& box, const QString& text,
                bool selected, double size = 1);
QSizeF labelSize(const QFont& font, const QString& text, bool selected, double size = 1);
/// In which names are written, where other words of the view are in `font`.
QFont labelFont(const QFont& font, bool selected, double size = 1);

/// What the scale bar takes.
QRectF scaleBarBox(const QFont& font, const QRect& view, double pixelsPerMillimetre,
                   double left = 0);
/// A bar of a round length with its measure, in the lower left corner; so many pixels at the left
/// are taken by something else.
void paintScaleBar(QPainter& painter, const RenderStyle& style, const QRect& view,
                   double pixelsPerMillimetre, double taken = 0);

/// Round length for a scale bar of about `pixels`, and its text ("5 cm", "2 mm", "1 m").
struct ScaleBar {
    double millimetres;
    QString text;
};

ScaleBar scaleBarFor(double pixels, double pixelsPerMillimetre);

/// Paints over what OpenGL has drawn in a widget, in logical pixels and the widget's font. Not a
/// painter on the widget itself: while a window is grabbed, that would paint elsewhere. Only while
/// the widget's context is current.
class OverPainter {
public:
    explicit OverPainter(const QWidget& widget);

    QPainter& painter() { return painter_; }

private:
    QOpenGLPaintDevice device_;
    QPainter painter_;
};

/// The widget's size in pixels of the screen.
QSize devicePixels(const QWidget& widget);

/// Instead of a picture: why nothing can be drawn.
void paintProblem(QPainter& painter, const RenderStyle& style, const QRect& view,
                  const QString& problem);

}  // namespace toile::app
