// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeyEvent>
#include <QObject>
#include <QPointF>
#include <QString>

#include "app/views/tool_view.h"

class QPainter;

namespace toile::app {

/// Which tool is meant.
enum class ToolId { Select, Cut, Loop, Dart, Join, Measure, Grain };

inline constexpr int kToolCount = 7;

/// The pointer in a view.
struct Pointer {
    QPointF at;  ///< logical pixels from the view's upper left corner
    Qt::KeyboardModifiers modifiers;

    /// What is meant comes to the selection, or is taken out of it.
    bool adds() const { return modifiers & (Qt::ControlModifier | Qt::ShiftModifier); }
};

/// What the left mouse button and the keyboard do in the views while the tool is chosen. One tool
/// serves both views. It states what is to be done to the workspace; between press and release it
/// may hold the beginnings of it, which Escape throws away.
class Tool : public QObject {
    Q_OBJECT

public:
    explicit Tool(QObject* parent = nullptr) : QObject(parent) {}

    virtual ToolId id() const = 0;
    /// For the status bar: what mouse and keys do now, "Click: select · Ctrl+click: add". What
    /// moves the view is said elsewhere (`cameraHint`).
    virtual QString hint(ViewKind view) const = 0;
    virtual Qt::CursorShape cursor(ViewKind) const { return Qt::ArrowCursor; }

    /// The left button goes down. @return whether the tool takes the drag; if not, the drag moves
    /// the view, and `click` follows where the pointer has not moved.
    virtual bool press(ToolView&, const Pointer&) { return false; }
    /// With the button down, after `press` has taken the drag.
    virtual void drag(ToolView&, const Pointer&) {}
    /// The button comes up after `press` has taken the drag.
    virtual void release(ToolView&, const Pointer&) {}
    /// Pressed and released at one place, where `press` has not taken it.
    virtual void click(ToolView&, const Pointer&) {}
    virtual void doubleClick(ToolView&, const Pointer&) {}
    /// Without a button.
    virtual void hover(ToolView&, const Pointer&) {}
    /// The pointer has left the view.
    virtual void leave(ToolView&) {}

    /// True where the tool writes beside the pointer itself what there is to say.
    virtual bool speaks() const { return false; }
    /// True where the key means something to the tool now: it is asked before any shortcut.
    /// Escape is what leads back to selecting.
    virtual bool wants(const QKeyEvent& event) const { return event.key() == Qt::Key_Escape; }
    virtual void key(ToolView&, const QKeyEvent&) { emit finished(); }
    /// Throws away what has been begun.
    virtual void cancel() {}

    /// Over the view, logical pixels.
    virtual void paint(const ToolView&, QPainter&, const RenderStyle&) const {}

signals:
    /// What `paint` shows or `hint` says is another now.
    void changed();
    /// The person is done with the tool: back to selecting.
    void finished();
};

/// Which tool is chosen, as far as views have to know. Both views work with the same one.
class ToolChoice : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    Tool& current() const { return *current_; }

signals:
    void chosen(toile::app::ToolId id);
    /// The chosen tool shows something else now.
    void changed();

protected:
    Tool* current_ = nullptr;
};

}  // namespace toile::app
