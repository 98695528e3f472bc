// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/overlay_buttons.h"

#include <QMenu>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>

#include "app/actions/action_registry.h"

namespace toile::app {

OverlayButtons::OverlayButtons(QToolBar& bar, const ActionRegistry& actions)
    : QObject(&bar),
      last_{&actions[ActionId::OverlayStrain], &actions[ActionId::OverlayNone]},
      choice_(new QToolButton(&bar)) {
    choice_->setObjectName("overlayChoice");
    choice_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    choice_->setPopupMode(QToolButton::InstantPopup);
    choice_->setToolTip(tr("What is painted on the cloth, in both views"));
    choice_->setAccessibleName(tr("Overlay"));
    auto* menu = new QMenu(choice_);
    for (const ActionSpec& spec : actionTable()) {
        if (spec.work.group == ActionGroup::Overlay) {
            QAction& action = actions[spec.id];
            overlays_ << &action;
            menu->addAction(&action);
            connect(&action, &QAction::changed, this, &OverlayButtons::follow);
        }
    }
    choice_->setMenu(menu);
    bar.addWidget(choice_);
    for (std::size_t k = 0; k < kLast; ++k) {
        buttons_[k] = new QToolButton(&bar);
        buttons_[k]->setObjectName(QString("lastOverlay%1").arg(k + 1));
        buttons_[k]->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        bar.addWidget(buttons_[k]);
    }
    follow();
}

void OverlayButtons::follow() {
    const auto on =
        std::ranges::find_if(overlays_, [](auto* action) { return action->isChecked(); });
    QAction* now = on == overlays_.end() ? shown_ : *on;
    if (shown_ && now != shown_) {
        // What is called back changes places with what it follows; else the oldest goes.
        const auto called = std::ranges::find(last_, now);
        std::shift_right(last_.begin(), called == last_.end() ? called : called + 1, 1);
        last_.front() = shown_;
    }
    shown_ = now;
    show();
}

void OverlayButtons::show() {
    if (shown_) {
        choice_->setText(shown_->iconText());
        choice_->setIcon(shown_->icon());
    }
    choice_->setEnabled(overlays_.front()->isEnabled());
    for (std::size_t k = 0; k < kLast; ++k) {
        if (buttons_[k]->defaultAction() != last_[k]) {
            buttons_[k]->removeAction(buttons_[k]->defaultAction());
            buttons_[k]->setDefaultAction(last_[k]);
        }
    }
}

}  // namespace toile::app
