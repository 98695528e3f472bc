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

/// Text over the views. Logical pixels.

/// Caption in the upper left corner; `note` follows in smaller, fainter letters.
/// @param corner   of the free part of the view
/// @param onLabel  draws a background label, needed over cloth
void paintCaption(QPainter& painter, const RenderStyle& style, const QPointF& corner,
                  const QString& title, const QString& note, bool onLabel);
/// Bounding box of a caption.
QRectF captionBox(const QFont& font, const QPointF& corner, const QString& title,
                  const QString& note);

/// Whether the predicate holds at any point of a grid over a part of the view.
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

/// Whether any part of a line is inside a box.
bool crosses(const QLineF& line, const QRectF& box);

/// A name in a rounded box that keeps it legible on any cloth.
/// @param box   of the size returned by `labelSize`
/// @param size  font scale; smaller letters get smaller margins, too
void paintLabel(QPainter& painter, const RenderStyle& style, const QRectF& box, const QString& text,
                bool selected, double size = 1);
QSizeF labelSize(const QFont& font, const QString& text, bool selected, double size = 1);
/// The font of names in a view whose other text uses `font`.
QFont labelFont(const QFont& font, bool selected, double size = 1);

/// Bounding box of the scale bar.
QRectF scaleBarBox(const QFont& font, const QRect& view, double pixelsPerMillimetre,
                   double left = 0);
/// A bar of a round length with its measure, in the lower left corner, right of `taken` occupied
/// pixels.
void paintScaleBar(QPainter& painter, const RenderStyle& style, const QRect& view,
                   double pixelsPerMillimetre, double taken = 0);

/// Round length for a scale bar of about `pixels`, and its text ("5 cm", "2 mm", "1 m").
struct ScaleBar {
    double millimetres;
    QString text;
};

ScaleBar scaleBarFor(double pixels, double pixelsPerMillimetre);

/// Paints over the OpenGL content of a widget, in logical pixels and the widget's font. A QPainter
/// on the widget would paint elsewhere while the window is grabbed. Use only while the widget's
/// context is current.
class OverPainter {
public:
    explicit OverPainter(const QWidget& widget);

    QPainter& painter() { return painter_; }

private:
    QOpenGLPaintDevice device_;
    QPainter painter_;
};

/// The widget's size in device pixels.
QSize devicePixels(const QWidget& widget);

/// Paints the reason why nothing can be drawn.
void paintProblem(QPainter& painter, const RenderStyle& style, const QRect& view,
                  const QString& problem);

}  // namespace toile::app
