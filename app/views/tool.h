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

/// A place on the screen to reckon with.
inline Eigen::Vector2d pixels(const QPointF& at) {
    return {at.x(), at.y()};
}

enum class ViewKind { Garment, Pattern };

/// What a tool may ask of the view that it works in. Screen places are logical pixels from the
/// view's upper left corner.
class ToolView {
public:
    virtual ~ToolView() = default;

    virtual ViewKind kind() const = 0;
    /// Whether the cloth answers the pointer: not while it is on its way to the pattern.
    virtual bool answers() const = 0;
    /// The cloth under a pixel.
    virtual std::optional<SurfaceHit> hitAt(const QPointF& at) const = 0;
    /// The seam line, or free edge, nearest to a pixel, of those within so many pixels that are
    /// seen and count.
    virtual std::optional<SeamHit> seamHitAt(const QPointF& at, double pixels,
                                             const SeamFilter& counts) const = 0;
    /// Where a place on a piece is on the screen; nothing where it is not drawn: behind the eye, or
    /// of a piece that is not flat.
    virtual std::optional<QPointF> onScreen(int piece, int face,
                                            const Eigen::Vector3d& barycentric) const = 0;
    /// A point of the garment as it is worn.
    struct WornPlace {
        QPointF at;
        bool isHidden = false;  ///< other cloth lies before it
    };
    /// Where that is drawn, mm as the pieces are; nothing where it is not: in the pattern, on the
    /// way there, behind the eye.
    virtual std::optional<WornPlace> wornPlace(const Eigen::Vector3d&) const { return {}; }
    /// Both sides of a seam of the scene, as far as they are drawn.
    virtual std::vector<QPolygonF> seamOnScreen(int seam) const = 0;
    /// Where a place on one side of a seam is on the screen, `along` as in a SeamHit; nothing where
    /// it is not drawn.
    virtual std::optional<QPointF> onSeam(int seam, int side, double along) const = 0;
    /// The point of the sheet under a pixel, mm. In the pattern view only.
    virtual Eigen::Vector2d onSheet(const QPointF& at) const = 0;
    /// Of the sheet; in the garment view at the depth of its middle.
    virtual double pixelsPerMillimetre() const = 0;
    /// Shows the selected pieces; where there are none the selected seam, else everything.
    virtual void frameSelection() = 0;
    /// Everything of the garment.
    virtual void frameAll() = 0;
    /// Paints again soon.
    virtual void repaintSoon() = 0;
};

/// From the sheet to the screen, in the pattern view; the way back is ToolView::onSheet.
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

/// Which tool is meant.
enum class ToolId { Select, Cut, Loop, Dart, Join, Measure, Grain, Notch, InternalLine };

inline constexpr int kToolCount = 9;

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
