// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>
#include <QPointF>
#include <QWidget>

namespace toile::test {

/// Mouse input to one widget, in its coordinates, to a fraction of a pixel. Every event has been
/// handled when a function returns; no other event is processed, and no time passes.

void sendMouse(QWidget& widget, QEvent::Type type, const QPointF& at, Qt::MouseButton button,
               Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
/// Moves without a button.
void moveTo(QWidget& widget, const QPointF& at, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
/// Moves there and clicks with the left button.
void click(QWidget& widget, const QPointF& at, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
/// Sends the events of a window system: a first click, and the second one as a double click.
void doubleClick(QWidget& widget, const QPointF& at);
/// Drags in several moves.
void drag(QWidget& widget, const QPointF& from, const QPointF& to,
          Qt::MouseButton button = Qt::LeftButton,
          Qt::KeyboardModifiers modifiers = Qt::NoModifier);
/// Positive notches turn the wheel away from the user.
void turnWheel(QWidget& widget, const QPointF& at, int notches);
void leave(QWidget& widget);

}  // namespace toile::test
