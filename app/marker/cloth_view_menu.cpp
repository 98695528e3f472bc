// SPDX-License-Identifier: GPL-3.0-or-later
// What the cloth says of a copy: its menu and its tip.
#include <QAction>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QToolTip>

#include "app/marker/cloth_view.h"
#include "app/marker/marker_desk.h"

namespace toile::app {

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

}  // namespace toile::app
