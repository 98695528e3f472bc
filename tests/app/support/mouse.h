// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>
#include <QPointF>
#include <QWidget>

namespace toile::test {

/// A mouse at work on one widget, in its coordinates, to a fraction of a pixel. Every event has
/// been handled when a function returns; no other event is, and no time passes.

void sendMouse(QWidget& widget, QEvent::Type type, const QPointF& at, Qt::MouseButton button,
               Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
/// Without a button.
void moveTo(QWidget& widget, const QPointF& at, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
/// With the left button, after a move to there.
void click(QWidget& widget, const QPointF& at, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
/// As a window system sends it: the first click, then the second one as a double click.
void doubleClick(QWidget& widget, const QPointF& at);
/// In several moves.
void drag(QWidget& widget, const QPointF& from, const QPointF& to,
          Qt::MouseButton button = Qt::LeftButton,
          Qt::KeyboardModifiers modifiers = Qt::NoModifier);
/// Positive notches are away from the person.
void turnWheel(QWidget& widget, const QPointF& at, int notches);
void leave(QWidget& widget);

}  // namespace toile::test
