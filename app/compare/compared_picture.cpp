// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare/compared_picture.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QWheelEvent>
#include <cmath>
#include <utility>

#include "app/views/view_text.h"

namespace toile::app {

namespace {

/// Enlargement per wheel notch (120 units) and per press of a key, as in the large views.
constexpr double kZoomPerNotch = 1.15;
/// How far an arrow key moves, logical pixels.
constexpr double kStep = 24;
/// Room below for the scale bar.
constexpr Camera2D::Margins kMargins{14, 14, 50};

}  // namespace

Camera2D LinkedCamera::seenIn(const QSizeF& size) const {
    Camera2D camera = camera_;
    camera.setViewport(size.width(), size.height());
    return camera;
}

void LinkedCamera::setBox(const Eigen::AlignedBox2d& box) {
    const bool isSame = box.isEmpty() ? box_.isEmpty() : box.isApprox(box_, 1e-9);
    if (!isSame) {
        box_ = box;
        follow();
    }
}

void LinkedCamera::setViewport(const QSizeF& size) {
    camera_.setViewport(size.width(), size.height());
    follow();
}

void LinkedCamera::follow() {
    if (followsAll_) {
        camera_.frame(box_, kMargins);
    }
    emit moved();
}

void LinkedCamera::pan(const QPointF& delta) {
    followsAll_ = false;
    camera_.pan(delta.x(), delta.y());
    emit moved();
}

void LinkedCamera::zoomAt(const QPointF& at, double factor) {
    followsAll_ = false;
    camera_.zoomAt(at.x(), at.y(), factor);
    emit moved();
}

void LinkedCamera::frameAll() {
    followsAll_ = true;
    follow();
}

ComparedPicture::ComparedPicture(LinkedCamera& camera, bool hasScaleBar, QWidget* parent)
    : QOpenGLWidget(parent), camera_(camera), hasScaleBar_(hasScaleBar) {
    setMinimumSize(120, 120);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::OpenHandCursor);
    connect(&camera_, &LinkedCamera::moved, this, [this] { update(); });
}

ComparedPicture::~ComparedPicture() {
    // The context dies after this part of the object: it must not call back then.
    if (context()) {
        disconnect(context(), nullptr, this, nullptr);
    }
    releaseGl();
}

void ComparedPicture::releaseGl() {
    if (context()) {
        makeCurrent();
        renderer_.release();
        doneCurrent();
    }
}

void ComparedPicture::setPiece(std::shared_ptr<const Scene> scene, const SheetPlace& place,
                               const PictureLook& look) {
    view_ = look.view;
    renderer_.show(
        {.scene = std::move(scene), .places = {place}, .fabric = look.fabric, .scale = look.scale});
    update();
}

void ComparedPicture::initializeGL() {
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &ComparedPicture::releaseGl,
            Qt::UniqueConnection);
    problem_ = renderer_.initialize();
}

void ComparedPicture::paintGL() {
    if (problem_.isEmpty()) {
        const QSize onDevice = devicePixels(*this);
        renderer_.paint(camera_.seenIn(size()), view_, renderStyle(palette()), onDevice.width(),
                        onDevice.height(), devicePixelRatioF());
    }
    paintWords();
}

void ComparedPicture::paintWords() {
    OverPainter over(*this);
    QPainter& painter = over.painter();
    const RenderStyle style = renderStyle(palette());
    if (!problem_.isEmpty()) {
        paintProblem(painter, style, rect(), problem_);
    } else if (hasScaleBar_) {
        paintScaleBar(painter, style, rect(), camera_.seenIn(size()).pixelsPerMillimetre());
    }
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
    }
}

void ComparedPicture::resizeEvent(QResizeEvent* event) {
    QOpenGLWidget::resizeEvent(event);
    camera_.setViewport(size());
}

void ComparedPicture::mousePressEvent(QMouseEvent* event) {
    last_ = event->position();
    setCursor(Qt::ClosedHandCursor);
    event->accept();
}

void ComparedPicture::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() != Qt::NoButton) {
        camera_.pan(event->position() - last_);
        last_ = event->position();
    }
    event->accept();
}

void ComparedPicture::mouseReleaseEvent(QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton) {
        setCursor(Qt::OpenHandCursor);
    }
    event->accept();
}

void ComparedPicture::mouseDoubleClickEvent(QMouseEvent* event) {
    last_ = event->position();
    camera_.frameAll();
    event->accept();
}

void ComparedPicture::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    camera_.zoomAt(event->position(), std::pow(kZoomPerNotch, notches));
    event->accept();
}

void ComparedPicture::keyPressEvent(QKeyEvent* event) {
    const QPointF middle = QRectF(rect()).center();
    switch (event->key()) {
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            return camera_.zoomAt(middle, kZoomPerNotch);
        case Qt::Key_Minus:
            return camera_.zoomAt(middle, 1 / kZoomPerNotch);
        case Qt::Key_F:
            return camera_.frameAll();
        case Qt::Key_Left:
            return camera_.pan({kStep, 0});
        case Qt::Key_Right:
            return camera_.pan({-kStep, 0});
        case Qt::Key_Up:
            return camera_.pan({0, kStep});
        case Qt::Key_Down:
            return camera_.pan({0, -kStep});
        default:
            QOpenGLWidget::keyPressEvent(event);
    }
}

}  // namespace toile::app
