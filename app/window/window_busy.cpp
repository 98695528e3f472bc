// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_busy.h"

#include <algorithm>

#include "app/session/workspace.h"
#include "app/widgets/busy_sheet.h"

namespace toile::app {

namespace {

constexpr int kDelayMilliseconds = 150;

}  // namespace

WindowBusy::WindowBusy(Workspace& workspace, QAction& cancel, QWidget& centre, QWidget* pattern)
    : QObject(&centre),
      workspace_(workspace),
      page_(new BusySheet(cancel, &centre)),
      sheet_(pattern ? new BusySheet(cancel, pattern) : nullptr) {
    page_->setObjectName("busyPage");
    if (sheet_) {
        sheet_->setObjectName("busySheet");
        sheet_->hide();
    }
    delay_.setSingleShot(true);
    delay_.setInterval(kDelayMilliseconds);
    connect(&delay_, &QTimer::timeout, this, [this] {
        if (sheet_ && isPatternAwaited()) {
            sheet_->show();
        }
    });
    const JobRunner& jobs = workspace_.jobs();
    connect(&jobs, &JobRunner::started, this, &WindowBusy::update);
    connect(&jobs, &JobRunner::idle, this, &WindowBusy::update);
    connect(&jobs, &JobRunner::progressed, this, &WindowBusy::showFraction);
    connect(&workspace_.document(), &Document::changed, this, [this](const DocumentChange& what) {
        if (what.touches(&Derived::garment, &Derived::results)) {
            update();
        }
    });
}

bool WindowBusy::isReading() const {
    return workspace_.jobs().isBusy() && !workspace_.document().garment();
}

bool WindowBusy::isPatternAwaited() const {
    const PieceResults& results = workspace_.document().results();
    return workspace_.jobs().isBusy() && workspace_.document().garment() &&
           std::ranges::all_of(results, [](const auto& result) { return !result; });
}

void WindowBusy::update() {
    sayTask();
    emit changed();
    if (!sheet_) {
        return;
    }
    if (!isPatternAwaited()) {
        delay_.stop();
        sheet_->hide();
    } else if (delay_.interval() == 0) {
        sheet_->show();
    } else if (!sheet_->isVisible() && !delay_.isActive()) {
        delay_.start();
    }
}

void WindowBusy::sayTask() {
    const JobRunner& jobs = workspace_.jobs();
    for (BusySheet* sheet : {page_, sheet_}) {
        if (sheet) {
            sheet->say(jobs.title(), jobs.detail());
        }
    }
}

void WindowBusy::showFraction() {
    sayTask();  // details of a file become known while it is read
    const double fraction = workspace_.jobs().fraction();
    page_->setFraction(fraction);
    if (sheet_) {
        sheet_->setFraction(fraction);
    }
}

}  // namespace toile::app
