// SPDX-License-Identifier: GPL-3.0-or-later
// Input handling of ClothView.
#include <QAction>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>
#include <utility>

#include "app/marker/cloth_view.h"
#include "app/marker/marker_desk.h"
#include "core/base/units.h"

namespace toile::app {

namespace {

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
        emit said(tr("This marker allows only one direction. Change Direction first."));
    }
}

void ClothView::dragTo(const QPointF& at, Qt::KeyboardModifiers modifiers) {
    const Eigen::Vector2d place = onCloth(at);
    if (selected() < 0) {  // the copy no longer exists
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
    dragged_ = drag_->movedTo(place, snaps ? kSnapRadius / map().pixelsPerMillimetre() : 0);
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
                   isTurn ? tr("Turn %1 on the cloth") : tr("Place %1 on the cloth"));
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
    if (isHeld_ || isDragging() || canvas_.button() != Qt::NoButton) {
        return;  // ignore other buttons during a drag
    }
    pressed_ = event->position();
    emit said({});
    if (event->button() != Qt::LeftButton || canvas_.hasSpace() || !desk_.marker()) {
        return canvas_.press(*event);
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
    if (!isHeld_) {
        canvas_.press(*event);
    }
}

void ClothView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (canvas_.button() != Qt::NoButton) {
        canvas_.drag(*event);
        return updateCursor(at);
    }
    if (isHeld_ && !drag_ && selected() >= 0 && (at - pressed_).manhattanLength() >= kDragBegins) {
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
    if (event->button() == canvas_.button()) {
        if (!canvas_.release() && event->button() == Qt::RightButton) {
            showMenu(event->position().toPoint(), copyAt(event->position()));
        }
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
    canvas_.wheel(*event);
}

void ClothView::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Escape:
            if (isDragging() || isHeld_) {
                return cancelDrag();
            }
            if (selected() >= 0) {
                return select(-1);
            }
            return QWidget::keyPressEvent(event);
        case Qt::Key_R:
            return turnSelected(event->modifiers().testFlag(Qt::ShiftModifier));
        default:
            if (!canvas_.keyPress(*event)) {
                QWidget::keyPressEvent(event);
            }
            updateCursor(mapFromGlobal(QCursor::pos()));
    }
}

void ClothView::keyReleaseEvent(QKeyEvent* event) {
    if (canvas_.keyRelease(*event)) {
        updateCursor(mapFromGlobal(QCursor::pos()));
    } else {
        QWidget::keyReleaseEvent(event);
    }
}

void ClothView::focusOutEvent(QFocusEvent* event) {
    canvas_.setSpace(false);
    QWidget::focusOutEvent(event);
}

void ClothView::updateCursor(const QPointF& at) {
    setCursor(canvas_.button() != Qt::NoButton ? Qt::ClosedHandCursor
              : canvas_.hasSpace()             ? Qt::OpenHandCursor
              : isOnHandle(at)                 ? Qt::CrossCursor
              : copyAt(at) >= 0                ? Qt::SizeAllCursor
                                               : Qt::ArrowCursor);
}

void ClothView::contextMenuEvent(QContextMenuEvent* event) {
    // With the mouse, the release opens the menu, since a right drag moves the picture.
    if (event->reason() != QContextMenuEvent::Mouse && !isHeld_ && !isDragging()) {
        showMenu(event->pos(), selected());
    }
}

void ClothView::showMenu(const QPoint& at, int copy) {
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
        add(tr("&Keep here"), !isKept, [this, here] {
            if (const int now = selected(); now >= 0) {
                desk_.keep(now, here, tr("Keep %1 on the cloth"));
            }
        });
        add(tr("&Release"), isKept, [this] {
            if (const int now = selected(); now >= 0) {
                desk_.release(now);
            }
        });
        add(desk_.settings().turns == TurnRule::Free ? tr("&Turn by 90°") : tr("&Turn by 180°"),
            desk_.settings().turns != TurnRule::OneWay, [this] { turnSelected(false); });
        menu->addSeparator();
    }
    add(tr("Release &all"), !desk_.plan().kept.empty(), [this] { desk_.releaseAll(); });
    add(tr("&Show whole cloth"), true, [this] { frameAll(); });
    menu->popup(mapToGlobal(at));
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
                    ? tr("%1 overlaps another piece or leaves the cloth").arg(shape.name)
                : shape.isKept
                    ? tr("%1 is placed by hand; double-click to release it").arg(shape.name)
                    : shape.name,
                this);
        } else {
            QToolTip::hideText();
        }
        return true;
    }
    return QWidget::event(event);
}

}  // namespace toile::app
