// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeyEvent>
#include <QObject>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "app/render/camera.h"
#include "app/render/picking.h"
#include "app/render/render_style.h"

class QPainter;

namespace toile::app {

/// Converts a screen place to a vector.
inline Eigen::Vector2d pixels(const QPointF& at) {
    return {at.x(), at.y()};
}

enum class ViewKind { Garment, Pattern };

/// The view's interface for tools. Screen places are logical pixels from the view's upper left
/// corner.
class ToolView {
public:
    virtual ~ToolView() = default;

    virtual ViewKind kind() const = 0;
    /// Whether the cloth can be picked: not during the morph to the pattern.
    virtual bool answers() const = 0;
    /// The cloth under a pixel.
    virtual std::optional<SurfaceHit> hitAt(const QPointF& at) const = 0;
    /// The nearest seam line or free edge within a distance in pixels. Only visible ones that pass
    /// the filter count.
    virtual std::optional<SeamHit> seamHitAt(const QPointF& at, double pixels,
                                             const SeamFilter& counts) const = 0;
    /// Screen position of a place on a piece; nullopt if it is not drawn, because it is behind the
    /// eye or its piece is not flat.
    virtual std::optional<QPointF> onScreen(int piece, int face,
                                            const Eigen::Vector3d& barycentric) const = 0;
    /// A point of the worn garment on the screen.
    struct WornPlace {
        QPointF at;
        bool isHidden = false;  ///< other cloth is in front of it
    };
    /// Screen position of a point in 3D, mm; nullopt in the pattern, during the morph and behind
    /// the eye.
    virtual std::optional<WornPlace> wornPlace(const Eigen::Vector3d&) const { return {}; }
    /// Both sides of a seam on the screen, as far as they are drawn.
    virtual std::vector<QPolygonF> seamOnScreen(int seam) const = 0;
    /// Screen position of a place on one side of a seam, `along` as in a SeamHit; nullopt if it is
    /// not drawn.
    virtual std::optional<QPointF> onSeam(int seam, int side, double along) const = 0;
    /// The point of the sheet under a pixel, mm. Only in the pattern view.
    virtual Eigen::Vector2d onSheet(const QPointF& at) const = 0;
    /// Scale of the sheet; in the garment view at the depth of its middle.
    virtual double pixelsPerMillimetre() const = 0;
    /// Frames the selected pieces, else the selected seam, else everything.
    virtual void frameSelection() = 0;
    /// Frames the whole garment.
    virtual void frameAll() = 0;
    /// Schedules a repaint.
    virtual void repaintSoon() = 0;
};

/// Maps the sheet to the screen in the pattern view; the inverse is ToolView::onSheet.
class SheetMap {
public:
    explicit SheetMap(const ToolView& view)
        : corner_(view.onSheet({0, 0})), scale_(view.pixelsPerMillimetre()) {}
    explicit SheetMap(const Camera2D& camera)
        : corner_(camera.toWorld(0, 0)), scale_(camera.pixelsPerMillimetre()) {}

    double pixelsPerMillimetre() const { return scale_; }

    QPointF operator()(const Eigen::Vector2d& point) const {
        return {(point.x() - corner_.x()) * scale_, (corner_.y() - point.y()) * scale_};
    }

    QRectF operator()(const Eigen::AlignedBox2d& box) const {
        return QRectF((*this)(box.min()), (*this)(box.max())).normalized();
    }

private:
    Eigen::Vector2d corner_;  ///< upper left
    double scale_;
};

enum class ToolId { Select, Cut, Loop, Dart, Join, Measure, Grain, Notch, InternalLine };

inline constexpr int kToolCount = 9;

/// The pointer in a view.
struct Pointer {
    QPointF at;  ///< logical pixels from the view's upper left corner
    Qt::KeyboardModifiers modifiers;

    /// Whether the click adds to the selection or removes from it.
    bool adds() const { return modifiers & (Qt::ControlModifier | Qt::ShiftModifier); }
};

/// Defines what the left mouse button and the keyboard do in both views while it is chosen. Edits
/// the document through the workspace. Between press and release it may hold unfinished work, which
/// Escape discards.
class Tool : public QObject {
    Q_OBJECT

public:
    explicit Tool(QObject* parent = nullptr) : QObject(parent) {}

    virtual ToolId id() const = 0;
    /// For the status bar: current mouse and key actions, "Click: select · Ctrl+click: add".
    /// `cameraHint` describes moving the view.
    virtual QString hint(ViewKind view) const = 0;
    virtual Qt::CursorShape cursor(ViewKind) const { return Qt::ArrowCursor; }

    /// The left button goes down. @return whether the tool takes the drag; if not, the drag moves
    /// the view, and `click` follows if the pointer has not moved.
    virtual bool press(ToolView&, const Pointer&) { return false; }
    /// Moves with the button down, after `press` took the drag.
    virtual void drag(ToolView&, const Pointer&) {}
    /// The button comes up after `press` took the drag.
    virtual void release(ToolView&, const Pointer&) {}
    /// Pressed and released at one place, if `press` did not take it.
    virtual void click(ToolView&, const Pointer&) {}
    virtual void doubleClick(ToolView&, const Pointer&) {}
    /// Moves without a button.
    virtual void hover(ToolView&, const Pointer&) {}
    /// The pointer has left the view.
    virtual void leave(ToolView&) {}

    /// True if the tool writes its own note beside the pointer.
    virtual bool speaks() const { return false; }
    /// True if the tool uses the key now; takes precedence over shortcuts. By default, Escape
    /// returns to selecting.
    virtual bool wants(const QKeyEvent& event) const { return event.key() == Qt::Key_Escape; }
    virtual void key(ToolView&, const QKeyEvent&) { emit finished(); }
    /// Discards unfinished work.
    virtual void cancel() {}

    /// Paints over the view, logical pixels.
    virtual void paint(const ToolView&, QPainter&, const RenderStyle&) const {}

signals:
    /// The output of `paint` or `hint` has changed.
    void changed();
    /// The user is done with the tool; return to selecting.
    void finished();
};

/// The chosen tool as the views see it, shared by both.
class ToolChoice : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    Tool& current() const { return *current_; }

signals:
    void chosen(toile::app::ToolId id);
    /// The chosen tool has changed its display.
    void changed();

protected:
    Tool* current_ = nullptr;
};

}  // namespace toile::app
