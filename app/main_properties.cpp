// SPDX-License-Identifier: GPL-3.0-or-later
// The window's right-hand column, what is selected and what it is cut from, and where all docks
// lie.
#include <QDockWidget>
#include <array>

#include "app/main_window.h"
#include "app/panels/fabric_panel.h"
#include "app/panels/position_panel.h"
#include "app/views/view_area.h"

namespace toile {

namespace {

/// Logical pixels.
constexpr int kListsHeight = 215, kPropertiesWidth = 280, kPositionHeight = 240,
              kFabricHeight = 440;

}  // namespace

void MainWindow::makePropertyDocks() {
    position_ = new PositionPanel(workspace_.document(), actions_);
    positionDock_ = makeDock(tr("Position"), "positionDock", position_);
    fabric_ = new FabricPanel(workspace_.document());
    fabricDock_ = makeDock(tr("Fabric"), "fabricDock", fabric_);
    const auto onAction = [this](ActionId id, QDockWidget* dock, QWidget& field) {
        actions_.on(id, this, [dock, &field] {
            dock->show();
            dock->raise();
            field.setFocus(Qt::ShortcutFocusReason);
        });
    };
    onAction(ActionId::GoToPosition, positionDock_, position_->firstField());
    onAction(ActionId::GoToFabric, fabricDock_, fabric_->firstField());
    connect(fabric_, &FabricPanel::pieceActivated, views_, &ViewArea::frameSelection);
}

void MainWindow::arrangeDocks() {
    const std::array lists{piecesDock_, seamsDock_, problemsDock_, historyDock_};
    for (QDockWidget* dock : lists) {
        addDockWidget(Qt::BottomDockWidgetArea, dock);
    }
    for (std::size_t k = 1; k < lists.size(); ++k) {
        tabifyDockWidget(lists[k - 1], lists[k]);
    }
    piecesDock_->raise();
    // Beside the views, so that the lists have the window's whole width.
    addDockWidget(Qt::RightDockWidgetArea, positionDock_);
    addDockWidget(Qt::RightDockWidgetArea, fabricDock_);
    splitDockWidget(positionDock_, fabricDock_, Qt::Vertical);
}

std::array<QDockWidget*, 6> MainWindow::docks() const {
    return {piecesDock_, seamsDock_, problemsDock_, historyDock_, positionDock_, fabricDock_};
}

void MainWindow::showDocks() {
    for (QDockWidget* dock : docks()) {
        dock->show();
    }
    resizeDocks({piecesDock_}, {kListsHeight}, Qt::Vertical);
    resizeDocks({positionDock_}, {kPropertiesWidth}, Qt::Horizontal);
    resizeDocks({positionDock_, fabricDock_}, {kPositionHeight, kFabricHeight}, Qt::Vertical);
}

}  // namespace toile
