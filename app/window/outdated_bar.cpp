// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/outdated_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "app/actions/action_registry.h"
#include "app/actions/workspace.h"

namespace toile::app {

namespace {

constexpr int kBarAir = 8, kBelowCaption = 40;

}  // namespace

OutdatedBar::OutdatedBar(Workspace& workspace, const ActionRegistry& actions, QWidget& view)
    : QWidget(&view),
      workspace_(workspace),
      actions_(actions),
      exportTip_(actions[ActionId::ExportPattern].toolTip()),
      printTip_(actions[ActionId::PrintPattern].toolTip()) {
    setObjectName("outdatedBar");
    setAutoFillBackground(true);
    auto* label = new QLabel(tr("The pattern is out of date"), this);
    auto* button = new QPushButton(tr("Flatten now"), this);
    button->setObjectName("flattenNow");
    button->setToolTip(tr("Flatten what edits have changed"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kBarAir, kBarAir / 2, kBarAir / 2, kBarAir / 2);
    row->addWidget(label);
    row->addWidget(button);
    hide();
    view.installEventFilter(this);
    connect(button, &QPushButton::clicked, this,
            [this] { actions_[ActionId::FlattenAgain].trigger(); });
    connect(&workspace_, &Workspace::patternAged, this, &OutdatedBar::follow);
}

void OutdatedBar::follow(PatternAge age) {
    const bool isOutdated = age != PatternAge::UpToDate && !workspace_.document().results().empty();
    // What has begun is told by the status bar; only what waits is told here.
    const bool isWaiting = isOutdated && age == PatternAge::OutOfDate;
    const QString why = tr("The pattern is out of date: flatten it first");
    actions_[ActionId::ExportPattern].setToolTip(isOutdated ? why : exportTip_);
    actions_[ActionId::PrintPattern].setToolTip(isOutdated ? why : printTip_);
    setVisible(isWaiting);
    if (isWaiting) {
        placeIt();
    }
}

bool OutdatedBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget() && event->type() == QEvent::Resize && isVisible()) {
        placeIt();
    }
    return QWidget::eventFilter(watched, event);
}

void OutdatedBar::placeIt() {
    adjustSize();
    move((parentWidget()->width() - width()) / 2, kBelowCaption);
    raise();
}

}  // namespace toile::app
