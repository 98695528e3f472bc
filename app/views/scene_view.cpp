// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/scene_view.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
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

/// Radius of the cloth framed around a spot: a share of its piece, at least this many mm.
constexpr double kRadiusShare = 0.2, kMinRadius = 5;

bool lieElsewhere(const SheetPlaces& a, const SheetPlaces& b) {
    return !std::ranges::equal(a, b, {}, &SheetPlace::placement, &SheetPlace::placement);
}

}  // namespace

SceneView::SceneView(Document& document, ToolChoice& tools, std::unique_ptr<SceneRenderer> painter,
                     QWidget* parent)
    : RenderedWidget(std::move(painter), parent),
      document_(document),
      tools_(tools),
      hover_(document, *this),
      canvas_(*this, *this) {
    setFormat(sceneSurfaceFormat());
    setMinimumSize(220, 150);
    setMouseTracking(true);
    connect(&document_, &Document::opened, this, [this] { followsAll_ = true; });
    connect(&document_, &Document::changed, this, &SceneView::onChanged);
    connect(&document_, &Document::hovered, this, [this] {
        renderer().setHover(document_.hover());
        hover_.follow();
        update();
    });
    connect(&tools_, &ToolChoice::changed, this, &SceneView::updateCursor);
    connect(&tools_, &ToolChoice::chosen, this, &SceneView::endPress);
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, [this] {
        renderer().show(contentOf(document_));
        hover_.writeAgain();
        update();
    });
    renderer().show(contentOf(document_));
}

void SceneView::onChanged(const DocumentChange& what) {
    const SheetPlaces before = places();
    renderer().show(contentOf(document_));
    const bool othersFlat = what.touches(&Derived::garment, &Derived::results, &Derived::scene);
    // When the user moves a piece, do not move the sheet.
    const bool byHand = !othersFlat && lieElsewhere(places(), before);
    followsAll_ = followsAll_ && !(byHand && kind() == ViewKind::Pattern);
    if (othersFlat || what.touches(DocumentChange::Selection)) {
        shown_.reset();
    }
    if (what.hasOtherPieces()) {
        hover_.reset();  // its subject may no longer exist
    } else {
        hover_.writeAgain();
    }
    update();
}

const SheetPlaces& SceneView::places() const {
    return renderer().content().places;
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
            } else if (!line.isEmpty()) {  // the rest is behind the eye
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
    return !problem().isEmpty() || (document_.scene() && painted_.lock() == document_.scene());
}

void SceneView::paintGL() {
    setCameraViewport(width(), height());
    if (followsAll_ && scene() && document_.pieceCount() > 0) {
        framePieces(document_.everyPiece());
    }
    const RenderStyle style = renderStyle(palette());
    if (problem().isEmpty()) {
        const QSize onDevice = devicePixels(*this);
        paintScene(style, onDevice.width(), onDevice.height(), devicePixelRatioF());
    }

    OverPainter over(*this);
    QPainter& painter = over.painter();
    if (!problem().isEmpty()) {
        paintProblem(painter, style, rect(), problem());
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
    setCursor(canvas_.hasSpace() ? Qt::OpenHandCursor : tools_.current().cursor(kind()));
    update();
}

void SceneView::setSpace(bool isDown) {
    canvas_.setSpace(isDown);
    updateCursor();
}

void SceneView::turn(const QPointF& delta) {
    takeByHand();
    turnCamera(delta);
    update();
}

void SceneView::pan(const QPointF& delta) {
    takeByHand();
    panCamera(delta);
    update();
}

void SceneView::zoom(const QPointF& at, double factor) {
    takeByHand();
    zoomCamera(at, factor);
    update();
}

void SceneView::mousePressEvent(QMouseEvent* event) {
    event->accept();
    if (press_ != Press::None) {
        return;  // ignore other buttons during a press
    }
    pressed_ = event->position();
    twice_ = false;
    hover_.leave();
    button_ = event->button();
    if (button_ == Qt::LeftButton && clickOnOverlay(event->position())) {
        press_ = Press::Overlay;
    } else if (button_ == Qt::LeftButton && scene() && !canvas_.hasSpace() &&
               tools_.current().press(*this, {event->position(), event->modifiers()})) {
        press_ = Press::Tool;
    } else {
        press_ = Press::Camera;
        canvas_.press(*event);
    }
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
    const Pointer pointer{event->position(), event->modifiers()};
    if (press_ != Press::None && !event->buttons().testFlag(button_)) {
        endPress();  // the release was lost: a dialog opened, or the pen left
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
            canvas_.drag(*event);
            break;
        case Press::Overlay:
            break;
    }
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
    if (press_ == Press::None || event->button() != button_) {
        return;
    }
    const Press press = std::exchange(press_, Press::None);
    const bool dragged = canvas_.release();
    const bool twice = std::exchange(twice_, false);
    const Pointer pointer{event->position(), event->modifiers()};
    Tool& tool = tools_.current();
    if (press == Press::Tool) {
        tool.release(*this, pointer);
        if (twice && scene()) {
            tool.doubleClick(*this, pointer);
        }
    } else if (press == Press::Camera && !dragged && event->button() == Qt::LeftButton && scene() &&
               !canvas_.hasSpace()) {
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
    if (event->reason() != QContextMenuEvent::Mouse) {  // the right button may begin a drag
        emit menuWanted(rect().center(), false);
    }
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
    // Treat it as a press, because a drag may follow. The release tells a double click from a drag.
    const bool isFirst = press_ == Press::None;
    mousePressEvent(event);
    twice_ = isFirst && event->button() == Qt::LeftButton && !canvas_.hasSpace() &&
             (press_ == Press::Tool || press_ == Press::Camera);
}

void SceneView::endPress() {
    twice_ = false;
    canvas_.release();
    if (std::exchange(press_, Press::None) == Press::Tool) {
        tools_.current().cancel();
    }
}

void SceneView::wheelEvent(QWheelEvent* event) {
    canvas_.wheel(*event);
    if (event->isAccepted() && scene() && press_ == Press::None && hover_.isOn()) {
        emit pointed(hover_.move(*this, event->position(), !tools_.current().speaks()));
    }
}

bool SceneView::event(QEvent* event) {
    // A busy tool gets Escape and Enter before the window's shortcuts. During its drag, no shortcut
    // may change the data that it works on.
    if (event->type() == QEvent::ShortcutOverride &&
        (press_ == Press::Tool || tools_.current().wants(*static_cast<QKeyEvent*>(event)))) {
        event->accept();
        return true;
    }
    return RenderedWidget::event(event);
}

void SceneView::keyPressEvent(QKeyEvent* event) {
    if (scene() && tools_.current().wants(*event)) {
        tools_.current().key(*this, *event);
        event->accept();
    } else if (canvas_.keyPress(*event)) {
        updateCursor();
        event->accept();
    } else {
        RenderedWidget::keyPressEvent(event);
    }
}

void SceneView::keyReleaseEvent(QKeyEvent* event) {
    if (canvas_.keyRelease(*event)) {
        updateCursor();
        event->accept();
    } else {
        RenderedWidget::keyReleaseEvent(event);
    }
}

void SceneView::focusOutEvent(QFocusEvent* event) {
    setSpace(false);
    if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::MenuBarFocusReason) {
        endPress();
    }
    RenderedWidget::focusOutEvent(event);
}

void SceneView::hideEvent(QHideEvent* event) {
    endPress();
    RenderedWidget::hideEvent(event);
}

void SceneView::enterEvent(QEnterEvent* event) {
    RenderedWidget::enterEvent(event);
    emit entered();
}

void SceneView::leaveEvent(QEvent* event) {
    emit pointed({});
    hover_.leave();
    tools_.current().leave(*this);
    RenderedWidget::leaveEvent(event);
}

void SceneView::resizeEvent(QResizeEvent* event) {
    hover_.leave();
    RenderedWidget::resizeEvent(event);
}

}  // namespace toile::app
