// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/document/layout.h"
#include "app/views/tool.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/window_fixture.h"

namespace toile::test {

using namespace app;

/// Three pieces on the sheet of the pattern view, and a mouse there: two strips, "left" and
/// "middle", and a rectangle of 120 x 80 mm, "sheet". Snapping is off at first.
class SheetBench : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    /// Opens a window with the three pieces, flat.
    void init();
    void cleanup() { fixture_.close(); }

protected:
    WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    PatternView& view() { return fixture_.patternView(); }
    QAction& action(ActionId id) { return fixture_.action(id); }
    Placement placement(int piece) { return placementOf(document(), piece); }
    Eigen::AlignedBox2d box(int piece) { return boxOnSheet(document(), piece); }
    /// Number of undo steps that are done.
    int steps() { return document().history().index(); }

    QPointF onScreen(const Eigen::Vector2d& point) { return SheetMap(view())(point); }
    /// A point well inside the piece, away from its name.
    QPointF on(int piece);

    void press(const QPointF& at) {
        sendMouse(view(), QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
    }
    /// Moves with the left button held.
    void move(const QPointF& at) {
        sendMouse(view(), QEvent::MouseMove, at, Qt::NoButton, Qt::LeftButton);
    }
    void release(const QPointF& at) {
        sendMouse(view(), QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton);
    }
    void drag(const QPointF& from, const QPointF& to, Qt::KeyboardModifiers modifiers = {}) {
        test::drag(view(), from, to, Qt::LeftButton, modifiers);
    }

    /// Fits everything into the view and paints it, so that positions are known.
    void frameAll();
    /// Types into a field of the position form.
    void type(const char* field, const QString& text);
};

}  // namespace toile::test
