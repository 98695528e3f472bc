// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLWidget>
#include <QPointF>
#include <memory>

#include "app/render/camera.h"
#include "app/settings/choices.h"

class QEvent;
class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace toile::app {

class SceneRenderer;

/// A camera that a canvas moves. Places and distances are logical pixels of the widget.
class CanvasCamera {
public:
    virtual void turn(const QPointF& delta) { pan(delta); }
    virtual void pan(const QPointF& delta) = 0;
    /// Enlarges (factor > 1) about a place.
    virtual void zoom(const QPointF& at, double factor) = 0;
    /// Shows everything, and keeps doing so until the camera is moved.
    virtual void frameAll() = 0;

protected:
    ~CanvasCamera() = default;
};

/// Moves a camera by mouse, wheel and keys, the same way in every picture: drags as the user's
/// mouse scheme has them, Space with the left button, wheel, plus, minus, arrows and F. Its widget
/// passes on the events that it has no use for itself.
class Canvas {
public:
    /// @param widget       for its size; it and the camera must outlive this
    /// @param anyDragPans  the widget has no use for drags: those that the scheme does not know pan
    Canvas(QWidget& widget, CanvasCamera& camera, bool anyDragPans = false)
        : widget_(widget), camera_(camera), anyDragPans_(anyDragPans) {}

    /// Handles any event of a widget that has no use for it. @return whether it meant anything
    bool handle(QEvent& event);

    /// The user's mouse scheme, for all canvases.
    static void setNavigation(Navigation navigation);

    /// A button goes down.
    void press(const QMouseEvent& event);
    /// Moves the camera once the pointer is far enough from where it was pressed.
    void drag(const QMouseEvent& event);
    /// The button comes up. @return whether the pointer was dragged
    bool release();
    /// Which is down; Qt::NoButton: none.
    Qt::MouseButton button() const { return button_; }

    void wheel(QWheelEvent& event);
    /// @return whether the key means anything
    bool keyPress(const QKeyEvent& event);
    bool keyRelease(const QKeyEvent& event);
    /// While Space is down the left button moves the picture.
    bool hasSpace() const { return hasSpace_; }
    void setSpace(bool isDown) { hasSpace_ = isDown; }

private:
    QWidget& widget_;
    CanvasCamera& camera_;
    bool anyDragPans_;
    QPointF pressed_, last_;
    Qt::MouseButton button_ = Qt::NoButton;
    bool isDragged_ = false, hasSpace_ = false;
};

/// Looks at a flat sheet, and shows all of it until it is moved. Several pictures of one size can
/// share it: what moves one moves all, and a millimetre has the same size in each.
class SheetCamera : public QObject, public CanvasCamera {
    Q_OBJECT

public:
    explicit SheetCamera(const Camera2D::Margins& margins) : margins_(margins) {}

    const Camera2D& camera() const { return camera_; }
    /// As seen in a picture of this size.
    Camera2D seenIn(const QSizeF& size) const;
    /// What there is to see, mm.
    void setBox(const Eigen::AlignedBox2d& box);
    void setViewport(const QSizeF& size);
    void pan(const QPointF& delta) override;
    void zoom(const QPointF& at, double factor) override;
    void frameAll() override;

signals:
    void moved();

private:
    void follow();

    Camera2D::Margins margins_;
    Camera2D camera_;
    Eigen::AlignedBox2d box_;
    bool followsAll_ = true;
};

/// A widget that a renderer paints in: keeps what the renderer has on the GPU as long as the
/// context lives.
class RenderedWidget : public QOpenGLWidget {
    Q_OBJECT

public:
    ~RenderedWidget() override;

    /// Why nothing can be drawn; empty if all is well.
    const QString& problem() const { return problem_; }
    SceneRenderer& renderer() const { return *renderer_; }

protected:
    RenderedWidget(std::unique_ptr<SceneRenderer> painter, QWidget* parent);

    void initializeGL() override;

private:
    void releaseGl();

    std::unique_ptr<SceneRenderer> renderer_;
    QString problem_;
};

}  // namespace toile::app
