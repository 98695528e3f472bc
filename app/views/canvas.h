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

/// A camera moved by a canvas. Places and distances are logical pixels of the widget.
class CanvasCamera {
public:
    virtual void turn(const QPointF& delta) { pan(delta); }
    virtual void pan(const QPointF& delta) = 0;
    /// Enlarges (factor > 1) around a place.
    virtual void zoom(const QPointF& at, double factor) = 0;
    /// Shows everything, and keeps doing so until the camera is moved.
    virtual void frameAll() = 0;

protected:
    ~CanvasCamera() = default;
};

/// Moves a camera by mouse, wheel and keys: drags follow the user's mouse scheme; also Space with
/// the left button, wheel, plus, minus, arrows and F. Works the same in every picture. Its widget
/// passes on the events that it does not use itself.
class Canvas {
public:
    /// @param widget       gives the size; it and the camera must outlive this
    /// @param anyDragPans  drags unknown to the scheme pan; for widgets that use no drags
    Canvas(QWidget& widget, CanvasCamera& camera, bool anyDragPans = false)
        : widget_(widget), camera_(camera), anyDragPans_(anyDragPans) {}

    /// Handles an event that the widget does not use. @return whether it had an effect
    bool handle(QEvent& event);

    /// The user's mouse scheme, for all canvases.
    static void setNavigation(Navigation navigation);

    void press(const QMouseEvent& event);
    /// Moves the camera once the pointer has passed the start drag distance.
    void drag(const QMouseEvent& event);
    /// @return whether the pointer was dragged
    bool release();
    /// The pressed button, or Qt::NoButton.
    Qt::MouseButton button() const { return button_; }

    void wheel(QWheelEvent& event);
    /// @return whether the key has an effect
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

/// Views a flat sheet and shows all of it until the user moves it. Several pictures of one size can
/// share this camera: they move together, at the same scale.
class SheetCamera : public QObject, public CanvasCamera {
    Q_OBJECT

public:
    explicit SheetCamera(const Camera2D::Margins& margins) : margins_(margins) {}

    const Camera2D& camera() const { return camera_; }
    /// The camera for a picture of this size.
    Camera2D seenIn(const QSizeF& size) const;
    /// Extent of the content, mm.
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

/// A widget painted by a renderer. Keeps the renderer's GPU resources as long as the context lives.
class RenderedWidget : public QOpenGLWidget {
    Q_OBJECT

public:
    ~RenderedWidget() override;

    /// Why nothing can be drawn; empty if there is no problem.
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
