// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/scene_view.h"

#include <QApplication>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLPaintDevice>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>
#include <utility>

#include "app/document/document.h"
#include "app/render/scene.h"
#include "app/render/scene_renderer.h"

namespace toile {

namespace {

/// Enlargement per wheel notch (120 units): five notches double.
constexpr double kZoomPerNotch = 1.15;

}  // namespace

SceneView::SceneView(Document& document, std::unique_ptr<SceneRenderer> renderer, QWidget* parent)
    : QOpenGLWidget(parent), document_(document), renderer_(std::move(renderer)) {
    setFormat(sceneSurfaceFormat());
    setMinimumSize(220, 180);
    setFocusPolicy(Qt::StrongFocus);
    connect(&document_, &Document::changed, this, &SceneView::onChanged);
    renderer_->setScene(document_.scene());
    renderer_->setSelection(document_.selection());
    renderer_->setSeam(document_.seam());
}

SceneView::~SceneView() {
    // The context dies after this part of the object: it must not call back then.
    if (context()) {
        disconnect(context(), nullptr, this, nullptr);
    }
    releaseGl();
}

void SceneView::releaseGl() {
    if (!context()) {
        return;
    }
    makeCurrent();
    renderer_->release();
    doneCurrent();
}

void SceneView::onChanged(DocumentChanges what) {
    if (what.testFlag(DocumentChange::Garment)) {
        followsAll_ = true;
    }
    if (what & (DocumentChange::Garment | DocumentChange::Results)) {
        renderer_->setScene(document_.scene());
    }
    if (what.testFlag(DocumentChange::Selection)) {
        renderer_->setSelection(document_.selection());
    }
    if (what.testFlag(DocumentChange::SeamSelection)) {
        renderer_->setSeam(document_.seam());
    }
    update();
}

const Scene* SceneView::scene() const {
    return document_.scene().get();
}

std::set<int> SceneView::everyPiece() const {
    std::set<int> all;
    for (int i = 0; i < document_.pieceCount(); ++i) {
        all.insert(all.end(), i);
    }
    return all;
}

void SceneView::frameAll() {
    followsAll_ = true;
    update();
}

void SceneView::frameSelection() {
    if (!scene() || (document_.selection().empty() && !document_.seam())) {
        frameAll();
        return;
    }
    if (document_.selection().empty()) {
        frameSeam();
        return;
    }
    followsAll_ = false;
    setCameraViewport(width(), height());
    framePieces(document_.selection());
    update();
}

void SceneView::frameSeam() {
    const std::optional<int> seam = document_.seam();
    if (!scene() || !seam || *seam >= static_cast<int>(scene()->seams.size())) {
        return;
    }
    setCameraViewport(width(), height());
    if (frameLines(scene()->seams[static_cast<std::size_t>(*seam)])) {
        followsAll_ = false;
        update();
    }
}

bool SceneView::isUpToDate() const {
    return !problem_.isEmpty() || (painted_ && painted_ == document_.scene());
}

void SceneView::initializeGL() {
    // Also reached again when the widget moves to another window and gets another context.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &SceneView::releaseGl,
            Qt::UniqueConnection);
    problem_ = renderer_->initialize();
}

void SceneView::paintGL() {
    setCameraViewport(width(), height());
    if (followsAll_ && scene() && document_.pieceCount() > 0) {
        framePieces(everyPiece());
    }
    const RenderStyle style = renderStyle(palette());
    const double ratio = devicePixelRatioF();
    const QSize pixels(static_cast<int>(std::lround(width() * ratio)),
                       static_cast<int>(std::lround(height() * ratio)));
    if (problem_.isEmpty()) {
        paintScene(style, pixels.width(), pixels.height(), ratio);
    }

    // Not a painter on the widget itself: while a window is grabbed, that would paint elsewhere.
    QOpenGLPaintDevice device(pixels);
    device.setDevicePixelRatio(ratio);
    QPainter painter(&device);
    painter.setFont(font());
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    if (!problem_.isEmpty()) {
        painter.fillRect(rect(), style.bottom);
        painter.setPen(style.text);
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                         problem_);
    } else {
        paintText(painter, style);
    }
    painted_ = document_.scene();
}

void SceneView::mousePressEvent(QMouseEvent* event) {
    pressed_ = last_ = event->position();
    dragging_ = false;
    event->accept();
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton) {
        return;
    }
    if (!dragging_ &&
        (event->position() - pressed_).manhattanLength() < QApplication::startDragDistance()) {
        return;
    }
    dragging_ = true;
    followsAll_ = false;
    drag(event->modifiers().testFlag(Qt::ShiftModifier) ? Drag::Shift : Drag::Turn,
         event->position() - last_);
    last_ = event->position();
    update();
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
    if (!std::exchange(dragging_, false) && event->button() == Qt::LeftButton) {
        select(event->position(), event->modifiers());
    }
}

void SceneView::select(const QPointF& at, Qt::KeyboardModifiers modifiers) {
    const std::optional<int> piece = pieceAt(at);
    const bool adds = modifiers.testFlag(Qt::ControlModifier);
    if (piece && adds) {
        document_.toggleSelected(*piece);
    } else if (piece) {
        document_.setSelection({*piece});
    } else if (!adds) {
        document_.setSelection({});
        document_.setSeam({});
    }
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
    // Not a drag, and the release that follows selects the piece once more, which changes nothing.
    pressed_ = last_ = event->position();
    if (event->button() != Qt::LeftButton) {
        return;
    }
    if (const std::optional<int> piece = pieceAt(event->position())) {
        document_.setSelection({*piece});
        frameSelection();
    } else {
        frameAll();
    }
}

void SceneView::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    if (notches == 0) {
        return;
    }
    followsAll_ = false;
    zoom(event->position(), std::pow(kZoomPerNotch, notches));
    update();
    event->accept();
}

}  // namespace toile
