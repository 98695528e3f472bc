// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/mouse.h"

#include <QApplication>
#include <QMouseEvent>
#include <QWheelEvent>

namespace toile::test {

using namespace app;

namespace {

constexpr int kMoves = 8;       ///< of a drag
constexpr int kNotch = 15 * 8;  ///< of a wheel, as Qt counts its turn

}  // namespace

void sendMouse(QWidget& widget, QEvent::Type type, const QPointF& at, Qt::MouseButton button,
               Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers) {
    QMouseEvent event(type, at, widget.mapToGlobal(at), button, buttons, modifiers);
    QApplication::sendEvent(&widget, &event);
}

void moveTo(QWidget& widget, const QPointF& at, Qt::KeyboardModifiers modifiers) {
    sendMouse(widget, QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton, modifiers);
}

void click(QWidget& widget, const QPointF& at, Qt::KeyboardModifiers modifiers) {
    moveTo(widget, at, modifiers);
    sendMouse(widget, QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton, modifiers);
    sendMouse(widget, QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton, modifiers);
}

void doubleClick(QWidget& widget, const QPointF& at) {
    click(widget, at);
    sendMouse(widget, QEvent::MouseButtonDblClick, at, Qt::LeftButton, Qt::LeftButton);
    sendMouse(widget, QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton);
}

void drag(QWidget& widget, const QPointF& from, const QPointF& to, Qt::MouseButton button,
          Qt::KeyboardModifiers modifiers) {
    sendMouse(widget, QEvent::MouseButtonPress, from, button, button, modifiers);
    for (int i = 1; i <= kMoves; ++i) {
        sendMouse(widget, QEvent::MouseMove, from + (to - from) * i / double(kMoves), Qt::NoButton,
                  button, modifiers);
    }
    sendMouse(widget, QEvent::MouseButtonRelease, to, button, Qt::NoButton, modifiers);
}

void turnWheel(QWidget& widget, const QPointF& at, int notches) {
    QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, kNotch * notches}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &event);
}

void leave(QWidget& widget) {
    QEvent event(QEvent::Leave);
    QApplication::sendEvent(&widget, &event);
}

}  // namespace toile::test
