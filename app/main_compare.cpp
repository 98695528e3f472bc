// SPDX-License-Identifier: GPL-3.0-or-later
// The window that compares methods.
#include "app/compare/compare_window.h"
#include "app/main_window.h"

namespace toile {

void MainWindow::connectCompare() {
    connect(&actions_[ActionId::CompareMethods], &QAction::triggered, this,
            &MainWindow::compareMethods);
}

void MainWindow::compareMethods() {
    if (!compare_) {
        compare_ = new CompareWindow(workspace_.document(), workspace_.jobs(), this);
        connect(compare_, &CompareWindow::methodWanted, &workspace_, &Workspace::setMethod);
        // "Use this method" is taken back where it was done.
        compare_->addActions({&actions_[ActionId::Undo], &actions_[ActionId::Redo]});
    }
    compare_->show();
    compare_->raise();
    compare_->activateWindow();
}

}  // namespace toile
