// SPDX-License-Identifier: GPL-3.0-or-later
// The hands on the cloth: mouse and keys, and what they drag and turn.
#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <cmath>
#include <utility>

#include "app/marker/cloth_view.h"
#include "app/marker/marker_desk.h"
#include "core/base/units.h"

namespace toile::app {

namespace {

constexpr double kClothZoomPerNotch = 1.15;
constexpr double kKeyStep = 24;    // pixels
constexpr double kSnapRadius = 8;  // pixels
constexpr double kDragBegins = 4;  // pixels
constexpr double kTurnStep = 15 * kDegree;

}  // namespace

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
    if (isOnHandle(event->position())) {
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
                   std::pow(kClothZoomPerNotch, event->angleDelta().y() / 120.0));
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
            return zoom(kClothZoomPerNotch);
        case Qt::Key_Minus:
            return zoom(1 / kClothZoomPerNotch);
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

void ClothView::updateCursor(const QPointF& at) {
    setCursor(panning_          ? Qt::ClosedHandCursor
              : hasSpace_       ? Qt::OpenHandCursor
              : isOnHandle(at)  ? Qt::CrossCursor
              : copyAt(at) >= 0 ? Qt::SizeAllCursor
                                : Qt::ArrowCursor);
}

}  // namespace toile::app
