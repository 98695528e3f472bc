// SPDX-License-Identifier: GPL-3.0-or-later
// Longer than a file mostly is: the events of one widget, which share what is held and where.
#include "app/marker/cloth_view.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/marker/marker_desk.h"
#include "app/render/colour_map.h"
#include "app/render/render_style.h"
#include "app/text/figures.h"
#include "app/views/ruler.h"
#include "app/views/view_text.h"
#include "core/base/units.h"

namespace toile::app {

namespace {

constexpr double kZoomPerNotch = 1.15;
constexpr double kKeyStep = 24;    // pixels
constexpr double kSnapRadius = 8;  // pixels
constexpr double kDragBegins = 4;  // pixels
constexpr double kHandleAway = 22, kHandle = 6;
constexpr double kTurnStep = 15 * kDegree;
constexpr Camera2D::Margins kAround{kRulerBreadth + 16, kRulerBreadth + 26, 34};

QColor clothColour(const RenderStyle& style) {
    return style.onDark ? QColor(74, 78, 86) : QColor(255, 255, 255);
}

}  // namespace

ClothView::ClothView(MarkerDesk& desk, QWidget* parent) : QWidget(parent), desk_(desk) {
    setObjectName("clothView");
    setAccessibleName(tr("Cloth"));
    setMinimumSize(320, 240);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    connect(&desk_, &MarkerDesk::changed, this, &ClothView::refresh);
    connect(&desk_, &MarkerDesk::clothChanged, this, &ClothView::frameAll);
    refresh();
}

void ClothView::refresh() {
    shapes_.clear();
    const ClothMarker* marker = desk_.marker();
    if (!marker) {
        if (isDragging()) {
            cancelDrag();
        }
        update();
        return;
    }
    const Pattern& pattern = *desk_.pattern();
    for (const LaidCopy& copy : marker->copies) {
        const PatternPiece& piece = pattern.pieces[static_cast<std::size_t>(copy.piece)];
        ClothShape& shape = shapes_.emplace_back();
        shape.edge = laidOutline(pattern, copy);
        if (piece.cuttingLine.rows() > 0) {
            shape.seam = piece.outline * copy.placement.linear().transpose();
            shape.seam.rowwise() += copy.placement.offset.transpose();
        }
        shape.label = copy.placement.applied(labels_.of(desk_.pattern(), copy.piece));
        const double grain = grainOf(piece);
        shape.grain = copy.placement.linear() * Eigen::Vector2d(std::cos(grain), std::sin(grain));
        const int garmentPiece = pieceOf(copy);
        const int number = garmentPiece < 0 ? copy.piece : desk_.document().colourOf(garmentPiece);
        const Rgb colour = pieceColour(number);
        shape.colour = QColor(colour.r, colour.g, colour.b);
        shape.name = QString::fromStdString(piece.name);
        shape.isKept = copy.isKept;
        shape.isStated = piece.grain.has_value();
        shape.isSelected = selected_ && *selected_ == copy.key;
    }
    for (const int copy : desk_.misplaced()) {
        shapes_[static_cast<std::size_t>(copy)].isMisplaced = true;
    }
    if (followsAll_ && !isDragging()) {
        follow();
    }
    update();
}

void ClothView::follow() {
    if (const ClothMarker* marker = desk_.marker()) {
        camera_.setViewport(width(), height());
        Eigen::AlignedBox2d box(
            Eigen::Vector2d::Zero(),
            Eigen::Vector2d(std::max(marker->length, 1.0), std::max(marker->width, 1.0)));
        for (const ClothPart& part : marker->parts) {
            box.extend(geometry::boxAround(part.outline));
        }
        camera_.frame(box, kAround);
    }
}

void ClothView::frameAll() {
    followsAll_ = true;
    follow();
    update();
}

QPointF ClothView::placeOf(int copy) const {
    return map()(shapes_[static_cast<std::size_t>(copy)].label);
}

int ClothView::selected() const {
    const auto found = std::ranges::find(shapes_, true, &ClothShape::isSelected);
    return found == shapes_.end() ? -1 : static_cast<int>(found - shapes_.begin());
}

std::optional<QPointF> ClothView::handle() const {
    const int copy = selected();
    if (copy < 0 || !desk_.marker() || !turnsByDegrees(desk_.settings())) {
        return std::nullopt;
    }
    const QRectF box = map()(geometry::boxAround(shapes_[static_cast<std::size_t>(copy)].edge));
    return QPointF(box.center().x(), box.top() - kHandleAway);
}

Eigen::Vector2d ClothView::onCloth(const QPointF& at) const {
    return camera_.toWorld(at.x(), at.y());
}

/// The one that is painted last.
int ClothView::copyAt(const QPointF& at) const {
    const Eigen::Vector2d place = onCloth(at);
    int found = -1;
    for (std::size_t c = 0; c < shapes_.size(); ++c) {
        if (geometry::isInside(shapes_[c].edge, place) &&
            (found < 0 || shapes_[c].isSelected ||
             (shapes_[c].isMisplaced && !shapes_[static_cast<std::size_t>(found)].isSelected))) {
            found = static_cast<int>(c);
        }
    }
    return found;
}

void ClothView::select(int copy) {
    selected_.reset();
    if (copy >= 0) {
        const LaidCopy& laid = desk_.marker()->copies[static_cast<std::size_t>(copy)];
        selected_ = laid.key;
        if (const int piece = pieceOf(laid); piece >= 0) {
            desk_.document().setSelection({piece});
        }
    }
    refresh();
}

/// In the garment as it is now, of which the marker may not be yet; -1: it is no more there.
int ClothView::pieceOf(const LaidCopy& copy) const {
    const auto& garment = desk_.document().garment();
    if (!garment) {
        return -1;
    }
    const auto found = std::ranges::find(garment->pieces, copy.key.piece,
                                         [](const auto& piece) { return piece->id; });
    return found == garment->pieces.end() ? -1 : static_cast<int>(found - garment->pieces.begin());
}

void ClothView::turnSelected(bool clockwise) {
    const int copy = selected();
    if (copy < 0 || isDragging()) {
        return;
    }
    const LaidCopy& laid = desk_.marker()->copies[static_cast<std::size_t>(copy)];
    const auto turned = nextTurn(*desk_.pattern(), laid, desk_.settings(), clockwise);
    if (turned) {
        desk_.keep(copy, *turned, tr("Turn %1 on the cloth"));
        emit said({});
    } else {
        emit said(
            tr("All pieces lie one way on this cloth: choose another rule for turning first."));
    }
}

void ClothView::dragTo(const QPointF& at, Qt::KeyboardModifiers modifiers) {
    const Eigen::Vector2d place = onCloth(at);
    if (selected() < 0) {  // it is no more there
        return cancelDrag();
    }
    if (turning_) {
        const double angle = wrappedAngle(directionTo(turning_->middle, place) - turning_->from);
        turning_->now = turnedBy(*desk_.pattern(), turning_->before, desk_.settings(), angle,
                                 modifiers.testFlag(Qt::ShiftModifier) ? kTurnStep : 0);
        dragged_ = turning_->now;
        desk_.tryPlacement(selected(), turning_->now);
        return;
    }
    const bool snaps = desk_.document().view().snapping != modifiers.testFlag(Qt::AltModifier);
    dragged_ = drag_->movedTo(place, snaps ? kSnapRadius / camera_.pixelsPerMillimetre() : 0);
    desk_.tryPlacement(selected(), *dragged_);
}

void ClothView::endDrag() {
    const auto placement = std::exchange(dragged_, std::nullopt);
    const int copy = selected();
    const bool isTurn = turning_.has_value();
    drag_.reset();
    turning_.reset();
    if (placement && copy >= 0 && desk_.marker()) {
        desk_.keep(copy, *placement,
                   isTurn ? tr("Turn %1 on the cloth") : tr("Lay %1 on the cloth"));
    }
}

void ClothView::cancelDrag() {
    drag_.reset();
    turning_.reset();
    isHeld_ = false;
    if (std::exchange(dragged_, std::nullopt)) {
        desk_.takeBack();
    }
    update();
}

void ClothView::mousePressEvent(QMouseEvent* event) {
    if (isHeld_ || isDragging() || panning_ != Qt::NoButton) {
        return;  // one thing at a time
    }
    pressed_ = last_ = event->position();
    emit said({});
    if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && hasSpace_)) {
        panning_ = event->button();
        setCursor(Qt::ClosedHandCursor);
        return;
    }
    if (event->button() != Qt::LeftButton || !desk_.marker()) {
        return;
    }
    if (const auto at = handle(); at && QLineF(*at, event->position()).length() <= 2 * kHandle) {
        const int copy = selected();
        Turning turning{desk_.marker()->copies[static_cast<std::size_t>(copy)]};
        turning.middle = geometry::boxAround(shapes_[static_cast<std::size_t>(copy)].edge).center();
        turning.from = directionTo(turning.middle, onCloth(event->position()));
        turning_ = turning;
        return;
    }
    const int copy = copyAt(event->position());
    select(copy);
    isHeld_ = copy >= 0;
}

void ClothView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (panning_ != Qt::NoButton) {
        followsAll_ = false;
        camera_.pan(at.x() - last_.x(), at.y() - last_.y());
        last_ = at;
        update();
        return;
    }
    if (isHeld_ && !drag_ && QLineF(pressed_, at).length() >= kDragBegins && selected() >= 0) {
        drag_.emplace(*desk_.pattern(), *desk_.marker(), desk_.settings(), selected(),
                      onCloth(pressed_));
        setCursor(Qt::ClosedHandCursor);
    }
    if (isDragging()) {
        dragTo(at, event->modifiers());
    } else {
        updateCursor(at);
    }
}

void ClothView::mouseReleaseEvent(QMouseEvent* event) {
    if (panning_ != Qt::NoButton) {
        panning_ = event->button() == panning_ ? Qt::NoButton : panning_;
    } else if (event->button() == Qt::LeftButton) {
        isHeld_ = false;
        endDrag();
    }
    updateCursor(event->position());
}

void ClothView::mouseDoubleClickEvent(QMouseEvent* event) {
    const int copy = desk_.marker() ? copyAt(event->position()) : -1;
    if (event->button() != Qt::LeftButton) {
        return;
    }
    isHeld_ = false;
    if (copy < 0) {
        frameAll();
    } else if (shapes_[static_cast<std::size_t>(copy)].isKept) {
        desk_.release(copy);
    }
}

void ClothView::wheelEvent(QWheelEvent* event) {
    followsAll_ = false;
    camera_.zoomAt(event->position().x(), event->position().y(),
                   std::pow(kZoomPerNotch, event->angleDelta().y() / 120.0));
    update();
    event->accept();
}

void ClothView::keyPressEvent(QKeyEvent* event) {
    const auto zoom = [this](double factor) {
        followsAll_ = false;
        camera_.zoomAt(0.5 * width(), 0.5 * height(), factor);
        update();
    };
    const auto pan = [this](double dx, double dy) {
        followsAll_ = false;
        camera_.pan(dx, dy);
        update();
    };
    switch (event->key()) {
        case Qt::Key_Escape:
            if (isDragging() || isHeld_) {
                return cancelDrag();
            }
            if (selected() >= 0) {
                return select(-1);
            }
            return QWidget::keyPressEvent(event);
        case Qt::Key_Space:
            hasSpace_ = true;
            return updateCursor(mapFromGlobal(QCursor::pos()));
        case Qt::Key_F:
            return frameAll();
        case Qt::Key_R:
            return turnSelected(event->modifiers().testFlag(Qt::ShiftModifier));
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            return zoom(kZoomPerNotch);
        case Qt::Key_Minus:
            return zoom(1 / kZoomPerNotch);
        case Qt::Key_Left:
            return pan(kKeyStep, 0);
        case Qt::Key_Right:
            return pan(-kKeyStep, 0);
        case Qt::Key_Up:
            return pan(0, kKeyStep);
        case Qt::Key_Down:
            return pan(0, -kKeyStep);
        default:
            QWidget::keyPressEvent(event);
    }
}

void ClothView::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
        hasSpace_ = false;
        updateCursor(mapFromGlobal(QCursor::pos()));
    } else {
        QWidget::keyReleaseEvent(event);
    }
}

void ClothView::focusOutEvent(QFocusEvent* event) {
    hasSpace_ = false;
    QWidget::focusOutEvent(event);
}

void ClothView::contextMenuEvent(QContextMenuEvent* event) {
    if (isHeld_ || isDragging()) {
        return;
    }
    const int copy =
        event->reason() == QContextMenuEvent::Mouse ? copyAt(event->pos()) : selected();
    select(copy);
    auto* menu = new QMenu(this);
    menu->setObjectName("clothMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const bool isKept = copy >= 0 && shapes_[static_cast<std::size_t>(copy)].isKept;
    const auto add = [&](const QString& text, bool isEnabled, auto work) {
        QAction* action = menu->addAction(text);
        action->setEnabled(isEnabled);
        connect(action, &QAction::triggered, this, work);
    };
    if (copy >= 0) {
        const Placement here = desk_.marker()->copies[static_cast<std::size_t>(copy)].placement;
        add(tr("&Keep it here"), !isKept, [this, here] {
            if (const int now = selected(); now >= 0) {
                desk_.keep(now, here, tr("Keep %1 on the cloth"));
            }
        });
        add(tr("&Release it"), isKept, [this] {
            if (const int now = selected(); now >= 0) {
                desk_.release(now);
            }
        });
        add(desk_.settings().turns == TurnRule::Free ? tr("&Turn by a quarter")
                                                     : tr("&Turn by half"),
            desk_.settings().turns != TurnRule::OneWay, [this] { turnSelected(false); });
        menu->addSeparator();
    }
    add(tr("Release &all"), !desk_.plan().kept.empty(), [this] { desk_.releaseAll(); });
    add(tr("&Show all of the cloth"), true, [this] { frameAll(); });
    menu->popup(event->globalPos());
}

bool ClothView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const int copy = copyAt(help->pos());
        if (copy >= 0) {
            const ClothShape& shape = shapes_[static_cast<std::size_t>(copy)];
            QToolTip::showText(
                help->globalPos(),
                shape.isMisplaced
                    ? tr("%1: it lies on another piece or beyond the cloth").arg(shape.name)
                : shape.isKept ? tr("%1: kept here; double click to release it").arg(shape.name)
                               : shape.name,
                this);
        } else {
            QToolTip::hideText();
        }
        return true;
    }
    return QWidget::event(event);
}

void ClothView::updateCursor(const QPointF& at) {
    const auto hand = handle();
    const bool onHandle = hand && QLineF(*hand, at).length() <= 2 * kHandle;
    setCursor(panning_          ? Qt::ClosedHandCursor
              : hasSpace_       ? Qt::OpenHandCursor
              : onHandle        ? Qt::CrossCursor
              : copyAt(at) >= 0 ? Qt::SizeAllCursor
                                : Qt::ArrowCursor);
}

void ClothView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    camera_.setViewport(width(), height());
    if (followsAll_) {
        follow();
    }
}

void ClothView::paintHands(QPainter& painter, const RenderStyle& style) const {
    const SheetMap onScreen = map();
    painter.save();
    if (drag_) {
        painter.setPen(QPen(style.selection, 1.2, Qt::DashLine));
        for (const SnapLine& line : drag_->snapped().lines) {
            painter.drawLine(onScreen(line.from), onScreen(line.to));
        }
        if (const auto& vertex = drag_->snapped().vertex) {
            painter.setPen(QPen(style.selection, 2));
            painter.drawEllipse(onScreen(*vertex), kHandle, kHandle);
        }
    }
    if (const auto at = handle(); at && !drag_) {
        painter.setPen(QPen(style.selection, 1.5));
        painter.drawLine(*at, *at + QPointF(0, kHandleAway));
        painter.setBrush(style.labelFill);
        painter.drawEllipse(*at, kHandle, kHandle);
    }
    painter.restore();
}

void ClothView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const RenderStyle style = renderStyle(palette());
    QLinearGradient ground(0, 0, 0, height());
    ground.setColorAt(0, style.top);
    ground.setColorAt(1, style.bottom);
    painter.fillRect(rect(), ground);
    const ClothMarker* marker = desk_.marker();
    if (!marker) {
        paintProblem(painter, style, rect(), desk_.problem());
        return;
    }
    const SheetMap onScreen = map();
    paintCloth(painter, style, onScreen, *marker, desk_.settings(), clothColour(style));
    paintCopies(painter, style, onScreen, shapes_);
    paintHands(painter, style);
    const int chosen = selected();
    paintRulers(painter, style, rect(), onScreen, camera_.visible(), camera_.pixelsPerMillimetre(),
                chosen < 0 ? Eigen::AlignedBox2d()
                           : geometry::boxAround(shapes_[static_cast<std::size_t>(chosen)].edge));
}

}  // namespace toile::app
