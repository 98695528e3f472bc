// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLPaintDevice>
#include <QPainter>

class QWidget;

namespace toile {

struct RenderStyle;

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

}  // namespace toile
