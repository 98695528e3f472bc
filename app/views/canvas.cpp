// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/canvas.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QWheelEvent>
#include <cmath>
#include <utility>

#include "app/render/scene_renderer.h"
#include "app/views/navigation.h"

namespace toile::app {

namespace {

/// Zoom factor per wheel notch (120 units) or key press; five double the size.
constexpr double kZoomPerNotch = 1.15;
/// Zoom factor per pixel of a drag; 140 pixels double the size.
constexpr double kZoomPerPixel = 1.005;
/// Step of an arrow key, logical pixels.
constexpr double kKeyPan = 24;

Navigation canvasNavigation = Navigation::Toile;

}  // namespace

void Canvas::setNavigation(Navigation navigation) {
    canvasNavigation = navigation;
}

void Canvas::press(const QMouseEvent& event) {
    button_ = event.button();
    pressed_ = last_ = event.position();
    isDragged_ = false;
}

void Canvas::drag(const QMouseEvent& event) {
    if (!event.buttons().testFlag(button_)) {
        release();  // the release was lost: a dialog opened, or the pen left
    }
    isDragged_ = isDragged_ || (event.position() - pressed_).manhattanLength() >=
                                   QApplication::startDragDistance();
    if (button_ == Qt::NoButton || !isDragged_) {
        return;
    }
    const QPointF delta = event.position() - std::exchange(last_, event.position());
    const CameraMove move =
        hasSpace_ ? CameraMove::Pan : cameraMove(canvasNavigation, button_, event.modifiers());
    if (move == CameraMove::Turn) {
        camera_.turn(delta);
    } else if (move == CameraMove::Zoom) {
        camera_.zoom(pressed_, std::pow(kZoomPerPixel, -delta.y()));
    } else if (move == CameraMove::Pan || anyDragPans_) {
        camera_.pan(delta);
    }
}

bool Canvas::release() {
    button_ = Qt::NoButton;
    return std::exchange(isDragged_, false);
}

void Canvas::wheel(QWheelEvent& event) {
    const double notches = event.angleDelta().y() / 120.0;
    event.setAccepted(notches != 0);
    if (notches != 0) {
        camera_.zoom(event.position(), std::pow(kZoomPerNotch, notches));
    }
}

bool Canvas::keyPress(const QKeyEvent& event) {
    if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) {
        return false;
    }
    const QPointF middle = QRectF(widget_.rect()).center();
    switch (event.key()) {
        case Qt::Key_Space:
            setSpace(true);
            break;
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            camera_.zoom(middle, kZoomPerNotch);
            break;
        case Qt::Key_Minus:
            camera_.zoom(middle, 1 / kZoomPerNotch);
            break;
        case Qt::Key_F:
            camera_.frameAll();
            break;
        case Qt::Key_Left:
            camera_.pan({kKeyPan, 0});
            break;
        case Qt::Key_Right:
            camera_.pan({-kKeyPan, 0});
            break;
        case Qt::Key_Up:
            camera_.pan({0, kKeyPan});
            break;
        case Qt::Key_Down:
            camera_.pan({0, -kKeyPan});
            break;
        default:
            return false;
    }
    return true;
}

bool Canvas::keyRelease(const QKeyEvent& event) {
    const bool isSpace = event.key() == Qt::Key_Space && !event.isAutoRepeat();
    hasSpace_ = hasSpace_ && !isSpace;
    return isSpace;
}

bool Canvas::handle(QEvent& event) {
    switch (event.type()) {
        case QEvent::MouseButtonPress:
            press(static_cast<QMouseEvent&>(event));
            return true;
        case QEvent::MouseMove:
            drag(static_cast<QMouseEvent&>(event));
            return true;
        case QEvent::MouseButtonRelease:
            release();
            return true;
        case QEvent::MouseButtonDblClick:
            camera_.frameAll();
            return true;
        case QEvent::Wheel:
            wheel(static_cast<QWheelEvent&>(event));
            return event.isAccepted();
        case QEvent::KeyPress:
            return keyPress(static_cast<QKeyEvent&>(event));
        case QEvent::KeyRelease:
            return keyRelease(static_cast<QKeyEvent&>(event));
        default:
            return false;
    }
}

Camera2D SheetCamera::seenIn(const QSizeF& size) const {
    Camera2D camera = camera_;
    camera.setViewport(size.width(), size.height());
    return camera;
}

void SheetCamera::setBox(const Eigen::AlignedBox2d& box) {
    const bool isSame = box.isEmpty() ? box_.isEmpty() : box.isApprox(box_, 1e-9);
    if (!isSame) {
        box_ = box;
        follow();
    }
}

void SheetCamera::setViewport(const QSizeF& size) {
    camera_.setViewport(size.width(), size.height());
    follow();
}

void SheetCamera::follow() {
    if (followsAll_) {
        camera_.frame(box_, margins_);
    }
    emit moved();
}

void SheetCamera::pan(const QPointF& delta) {
    followsAll_ = false;
    camera_.pan(delta.x(), delta.y());
    emit moved();
}

void SheetCamera::zoom(const QPointF& at, double factor) {
    followsAll_ = false;
    camera_.zoomAt(at.x(), at.y(), factor);
    emit moved();
}

void SheetCamera::frameAll() {
    followsAll_ = true;
    follow();
}

RenderedWidget::RenderedWidget(std::unique_ptr<SceneRenderer> painter, QWidget* parent)
    : QOpenGLWidget(parent), renderer_(std::move(painter)) {
    setFocusPolicy(Qt::StrongFocus);
}

RenderedWidget::~RenderedWidget() {
    // The context dies after this part of the object, so it must not call back then.
    if (context()) {
        disconnect(context(), nullptr, this, nullptr);
    }
    releaseGl();
}

void RenderedWidget::releaseGl() {
    if (context()) {
        makeCurrent();
        renderer_->release();
        doneCurrent();
    }
}

void RenderedWidget::initializeGL() {
    // Runs again when the widget moves to another window and gets a new context.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &RenderedWidget::releaseGl,
            Qt::UniqueConnection);
    problem_ = renderer_->initialize();
}

}  // namespace toile::app
