// SPDX-License-Identifier: GPL-3.0-or-later
// Longer than a file mostly is: what both views do alike with the pointer, the camera and what is
// shown under them, which share the same few members.
#include "app/views/scene_view.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/document/document.h"
#include "app/render/scene.h"
#include "app/render/scene_renderer.h"
#include "app/settings/length_display.h"
#include "app/views/callouts.h"
#include "app/views/rolled_piece.h"
#include "app/views/sewn_run.h"
#include "app/views/tool.h"
#include "app/views/view_text.h"

namespace toile::app {

namespace {

/// Enlargement per wheel notch (120 units): five notches double.
constexpr double kZoomPerNotch = 1.15;
/// And per pixel of a drag: 140 pixels double.
constexpr double kZoomPerPixel = 1.005;
/// Cloth around a place that is shown: a part of its piece, at least so many mm.
constexpr double kRadiusShare = 0.2, kMinRadius = 5;

/// What is drawn anew then.
constexpr DocumentChanges kContent = DocumentChange::Garment | DocumentChange::Results |
                                     DocumentChange::Settings | DocumentChange::Fabric |
                                     DocumentChange::Selection | DocumentChange::SeamSelection |
                                     DocumentChange::Mark | DocumentChange::Reference |
                                     DocumentChange::Seams | DocumentChange::Proof;

bool lieElsewhere(const SheetPlaces& a, const SheetPlaces& b) {
    return !std::ranges::equal(a, b, {}, &SheetPlace::placement, &SheetPlace::placement);
}

}  // namespace

SceneView::SceneView(Document& document, ToolChoice& tools, std::unique_ptr<SceneRenderer> renderer,
                     QWidget* parent)
    : QOpenGLWidget(parent),
      document_(document),
      tools_(tools),
      hover_(document, *this),
      renderer_(std::move(renderer)) {
    setFormat(sceneSurfaceFormat());
    setMinimumSize(220, 150);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    connect(&document_, &Document::changed, this, &SceneView::onChanged);
    connect(&tools_, &ToolChoice::changed, this, &SceneView::updateCursor);
    connect(&tools_, &ToolChoice::chosen, this, &SceneView::endPress);
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, [this] {
        renderer_->show(contentOf(document_));
        hover_.writeAgain();
        update();
    });
    renderer_->show(contentOf(document_));
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
    if (what.testFlag(DocumentChange::Opened)) {
        followsAll_ = true;
    }
    if (what & kContent) {
        const SheetPlaces before = places();
        renderer_->show(contentOf(document_));
        // Who moves a piece wants the sheet to stay where it is.
        const bool byHand = !(what & (DocumentChange::Garment | DocumentChange::Results)) &&
                            lieElsewhere(places(), before);
        followsAll_ = followsAll_ && !(byHand && kind() == ViewKind::Pattern);
    }
    if (what & (DocumentChange::Garment | DocumentChange::Results | DocumentChange::Selection |
                DocumentChange::SeamSelection | DocumentChange::Mark)) {
        shown_.reset();
    }
    if (what.testFlag(DocumentChange::Hover)) {
        renderer_->setHover(document_.hover());
        hover_.follow();
    }
    if (what.testFlag(DocumentChange::Garment)) {
        hover_.reset();  // what the label is about may be no more
    } else if (what & (DocumentChange::Results | DocumentChange::Seams | DocumentChange::Settings |
                       DocumentChange::View | DocumentChange::Fabric | DocumentChange::Proof)) {
        hover_.writeAgain();
    }
    update();
}

const SheetPlaces& SceneView::places() const {
    return renderer_->content().places;
}

std::vector<QRectF> SceneView::covered() const {
    std::vector<QRectF> covered;
    for (const QWidget* over : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (over->isVisible() && !over->testAttribute(Qt::WA_TransparentForMouseEvents)) {
            covered.emplace_back(over->geometry());
        }
    }
    return covered;
}

std::vector<QPolygonF> SceneView::seamOnScreen(int seam) const {
    std::vector<QPolygonF> drawn;
    const auto index = static_cast<std::size_t>(seam);
    if (!scene() || index >= lines().seams.size()) {
        return drawn;
    }
    for (const VertexRun& run : lines().seams[index]) {
        QPolygonF line;
        for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
            if (const auto at = pointOnScreen(scene()->lineVertices[i])) {
                line << *at;
            } else if (!line.isEmpty()) {  // it goes on behind the eye
                drawn.push_back(std::exchange(line, {}));
            }
        }
        if (!line.isEmpty()) {
            drawn.push_back(line);
        }
    }
    return drawn;
}

std::optional<QPointF> SceneView::onSeam(int seam, int side, double along) const {
    const auto index = static_cast<std::size_t>(seam);
    if (!scene() || index >= lines().seams.size()) {
        return std::nullopt;
    }
    const VertexRun& run = lines().seams[index][static_cast<std::size_t>(side)];
    return run.count == 0 ? std::nullopt : pointOnScreen(pointAlong(*scene(), run, along));
}

std::optional<WorstSpot> SceneView::markedSpotAt(const QPointF& at, double pixels) const {
    std::optional<WorstSpot> nearest;
    if (!document_.view().worstSpots || spots_.overlay != document_.view().overlay) {
        return nearest;
    }
    for (const WorstSpot& spot : spots_.spots) {
        const auto place = placeNow(spot);
        const double distance = place ? QLineF(place->at, at).length() : pixels;
        if (distance < pixels) {
            pixels = distance;
            nearest = spot;
        }
    }
    return nearest;
}

void SceneView::setWorstSpots(FlaggedSpots spots) {
    spots_ = std::move(spots);
    update();
}

void SceneView::setSeamDot(std::optional<SeamDot> dot) {
    if (dot || dot_) {
        dot_ = dot;
        update();
    }
}

void SceneView::stopFollowing() {
    followsAll_ = false;
    cameraMoved();
}

void SceneView::takeByHand() {
    const auto isSeen = [this](const auto& piece) {
        return kind() == ViewKind::Garment || piece.flat;
    };
    followsAll_ = followsAll_ && !(scene() && std::ranges::any_of(scene()->pieces, isSeen));
}

const Scene* SceneView::scene() const {
    return document_.scene().get();
}

void SceneView::cameraMoved() {
    hover_.leave();
    emit pointed({});
    update();
}

void SceneView::frameAll() {
    followsAll_ = true;
    cameraMoved();
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
    setCameraViewport(width(), height());
    framePieces(document_.selection());
    stopFollowing();
}

void SceneView::frameSeam() {
    const std::optional<int> seam = document_.seam();
    if (!scene() || !seam || *seam >= static_cast<int>(scene()->seams.size())) {
        return;
    }
    setCameraViewport(width(), height());
    if (frameLines(scene()->seams[static_cast<std::size_t>(*seam)])) {
        stopFollowing();
    }
}

void SceneView::showSpot(const WorstSpot& spot) {
    const auto piece = static_cast<std::size_t>(spot.piece);
    if (!scene() || piece >= scene()->pieces.size() || !scene()->pieces[piece].flat) {
        return;
    }
    const double size = scene()->pieces[piece].flatBox.diagonal().norm();
    setCameraViewport(width(), height());
    frameSpot(spot, std::max(kMinRadius, kRadiusShare * size));
    shown_ = spot;
    stopFollowing();
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
        framePieces(document_.everyPiece());
    }
    const RenderStyle style = renderStyle(palette());
    if (problem_.isEmpty()) {
        const QSize onDevice = devicePixels(*this);
        paintScene(style, onDevice.width(), onDevice.height(), devicePixelRatioF());
    }

    OverPainter over(*this);
    QPainter& painter = over.painter();
    if (!problem_.isEmpty()) {
        paintProblem(painter, style, rect(), problem_);
    } else {
        paintText(painter, style);
        if (const auto place = shown_ ? placeNow(*shown_) : std::nullopt) {
            paintSpotRing(painter, style, place->at);
        }
        paintVertexDots(painter, style, *this, document_);
        if (const auto at = dot_ ? onSeam(dot_->seam, 0, dot_->along) : std::nullopt) {
            paintSeamDot(painter, style, *at);
        }
        tools_.current().paint(*this, painter, style);
    }
    painted_ = document_.scene();
}

void SceneView::updateCursor() {
    setCursor(space_ ? Qt::OpenHandCursor : tools_.current().cursor(kind()));
    update();
}

void SceneView::setSpace(bool down) {
    if (down != space_) {
        space_ = down;
        updateCursor();
    }
}

void SceneView::mousePressEvent(QMouseEvent* event) {
    event->accept();
    if (press_ != Press::None) {
        return;  // another button while one is down
    }
    pressed_ = last_ = event->position();
    dragging_ = twice_ = false;
    hover_.leave();
    button_ = event->button();
    if (button_ == Qt::LeftButton && clickOnOverlay(event->position())) {
        press_ = Press::Overlay;
        return;
    }
    const bool taken = event->button() == Qt::LeftButton && scene() && !space_ &&
                       tools_.current().press(*this, {event->position(), event->modifiers()});
    press_ = taken ? Press::Tool : Press::Camera;
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
    const Pointer pointer{event->position(), event->modifiers()};
    if (press_ != Press::None && !event->buttons().testFlag(button_)) {
        endPress();  // a dialog came up, or the pen went away
    }
    if ((pointer.at - pressed_).manhattanLength() >= QApplication::startDragDistance()) {
        twice_ = false;
    }
    switch (press_) {
        case Press::None:
            if (scene()) {
                emit pointed(hover_.move(*this, event->position(), !tools_.current().speaks()));
                tools_.current().hover(*this, pointer);
            }
            break;
        case Press::Tool:
            tools_.current().drag(*this, pointer);
            break;
        case Press::Camera:
            moveCamera(event);
            break;
        case Press::Overlay:
            break;
    }
}

void SceneView::moveCamera(QMouseEvent* event) {
    if (!dragging_ &&
        (event->position() - pressed_).manhattanLength() < QApplication::startDragDistance()) {
        return;
    }
    dragging_ = true;
    const QPointF delta = event->position() - last_;
    const CameraMove move =
        space_ ? CameraMove::Pan : cameraMove(navigation_, button_, event->modifiers());
    if (move == CameraMove::None) {
        return;
    }
    takeByHand();
    switch (move) {
        case CameraMove::Turn:
            drag(Drag::Turn, delta);
            break;
        case CameraMove::Pan:
            drag(Drag::Shift, delta);
            break;
        case CameraMove::Zoom:
            zoom(pressed_, std::pow(kZoomPerPixel, -delta.y()));
            break;
        case CameraMove::None:
            break;
    }
    last_ = event->position();
    update();
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
    if (press_ == Press::None || event->button() != button_) {
        return;
    }
    const Press press = std::exchange(press_, Press::None);
    const bool dragged = std::exchange(dragging_, false);
    const bool twice = std::exchange(twice_, false);
    const Pointer pointer{event->position(), event->modifiers()};
    Tool& tool = tools_.current();
    if (press == Press::Tool) {
        tool.release(*this, pointer);
        if (twice && scene()) {
            tool.doubleClick(*this, pointer);
        }
    } else if (press == Press::Camera && !dragged && event->button() == Qt::LeftButton && scene() &&
               !space_) {
        if (twice) {
            tool.doubleClick(*this, pointer);
        } else {
            tool.click(*this, pointer);
        }
    } else if (press == Press::Camera && !dragged && event->button() == Qt::RightButton &&
               scene()) {
        emit menuWanted(event->position(), true);
    }
}

void SceneView::contextMenuEvent(QContextMenuEvent* event) {
    event->accept();
    if (event->reason() != QContextMenuEvent::Mouse) {  // that button may begin a drag: see above
        emit menuWanted(rect().center(), false);
    }
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
    // A press like any other: a drag may follow. What it is shows where the button comes up.
    const bool isFirst = press_ == Press::None;
    mousePressEvent(event);
    twice_ = isFirst && event->button() == Qt::LeftButton && !space_ &&
             (press_ == Press::Tool || press_ == Press::Camera);
}

void SceneView::endPress() {
    dragging_ = twice_ = false;
    if (std::exchange(press_, Press::None) == Press::Tool) {
        tools_.current().cancel();
    }
}

void SceneView::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    if (notches == 0) {
        return;
    }
    takeByHand();
    zoom(event->position(), std::pow(kZoomPerNotch, notches));
    if (scene() && press_ == Press::None && hover_.isOn()) {
        emit pointed(hover_.move(*this, event->position(), !tools_.current().speaks()));
    }
    update();
    event->accept();
}

bool SceneView::event(QEvent* event) {
    // A tool in the middle of something has Escape and Enter before the window's shortcuts; while
    // it drags, no shortcut may change what it holds.
    if (event->type() == QEvent::ShortcutOverride &&
        (press_ == Press::Tool || tools_.current().wants(*static_cast<QKeyEvent*>(event)))) {
        event->accept();
        return true;
    }
    return QOpenGLWidget::event(event);
}

void SceneView::keyPressEvent(QKeyEvent* event) {
    if (scene() && tools_.current().wants(*event)) {
        tools_.current().key(*this, *event);
        event->accept();
    } else if (event->key() == Qt::Key_Space && event->modifiers() == Qt::NoModifier) {
        setSpace(true);
        event->accept();
    } else {
        QOpenGLWidget::keyPressEvent(event);
    }
}

void SceneView::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
        setSpace(false);
        event->accept();
    } else {
        QOpenGLWidget::keyReleaseEvent(event);
    }
}

void SceneView::focusOutEvent(QFocusEvent* event) {
    setSpace(false);
    if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::MenuBarFocusReason) {
        endPress();
    }
    QOpenGLWidget::focusOutEvent(event);
}

void SceneView::hideEvent(QHideEvent* event) {
    endPress();
    QOpenGLWidget::hideEvent(event);
}

void SceneView::enterEvent(QEnterEvent* event) {
    QOpenGLWidget::enterEvent(event);
    emit entered();
}

void SceneView::leaveEvent(QEvent* event) {
    emit pointed({});
    hover_.leave();
    tools_.current().leave(*this);
    QOpenGLWidget::leaveEvent(event);
}

void SceneView::resizeEvent(QResizeEvent* event) {
    hover_.leave();
    QOpenGLWidget::resizeEvent(event);
}

}  // namespace toile::app
