// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_status.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "app/actions/action_registry.h"
#include "app/jobs/ready_checker.h"
#include "app/panels/garment_summary.h"
#include "app/panels/problems_model.h"
#include "app/session/project_session.h"
#include "app/session/workspace.h"
#include "app/settings/length_display.h"
#include "app/widgets/hint_label.h"

namespace toile::app {

namespace {

constexpr int kMessageMilliseconds = 6000;
/// Time to read a sentence with a number.
constexpr int kWrittenMilliseconds = 10000;

}  // namespace

WindowStatus::WindowStatus(QStatusBar& bar, Workspace& workspace, const ActionRegistry& actions,
                           ProjectSession& session, const ReadyChecker& checker)
    : bar_(bar), workspace_(workspace), hint_(new HintLabel), summary_(new QToolButton) {
    hint_->setObjectName("toolHint");
    hint_->setContentsMargins(8, 0, 8, 0);
    hint_->setMinimumWidth(60);
    bar_.addWidget(hint_, 1);
    summary_->setObjectName("garmentSummary");
    summary_->setAutoRaise(true);
    summary_->setFocusPolicy(Qt::TabFocus);
    connect(summary_, &QToolButton::clicked, this, &WindowStatus::summaryWanted);
    bar_.addPermanentWidget(summary_);
    bar_.addPermanentWidget(new WorkDisplay(workspace.runners(), actions[ActionId::Cancel]));
    for (JobRunner* jobs : workspace.runners()) {
        connect(jobs, &JobRunner::cancelled, this, [this](const QString& title, bool replaced) {
            if (!replaced) {
                say(tr("%1: cancelled").arg(title));
            }
        });
    }
    connect(&session, &ProjectSession::saved, this,
            [this](const QString& path) { say(tr("Saved: %1").arg(path)); });
    connect(&workspace, &Workspace::noted, this, &WindowStatus::say);
    connect(&workspace, &Workspace::exported, this,
            [this, &checker](const QString& path, const QString& checked) {
                const int faults = checker.readiness().count(Severity::Fault);
                const QString written = checked.isEmpty() ? path : path + "; " + checked;
                bar_.showMessage(faults == 0
                                     ? tr("Written: %1").arg(written)
                                     : tr("Written: %1 (%2 left, see Problems)")
                                           .arg(written, severityCount(Severity::Fault, faults)),
                                 kWrittenMilliseconds);
            });
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this,
            &WindowStatus::updateSummary);
}

void WindowStatus::setHint(const QString& hint) {
    hint_->setHint(hint);
}

void WindowStatus::say(const QString& sentence) {
    bar_.showMessage(sentence, kMessageMilliseconds);
}

void WindowStatus::updateSummary() {
    const QString summary = garmentSummary(workspace_.document());
    summary_->setText(summary);
    summary_->setVisible(!summary.isEmpty());
    summary_->setToolTip(tr("%1\n\nClick to choose the unit or to enter the garment's height")
                             .arg(garmentReasons(workspace_.document())));
}

bool WindowStatus::hasSummary() const {
    return !summary_->text().isEmpty();
}

WorkDisplay::WorkDisplay(std::vector<JobRunner*> runners, QAction& cancel, QWidget* parent)
    : QWidget(parent),
      runners_(std::move(runners)),
      task_(new QLabel(this)),
      progress_(new QProgressBar(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    task_->setObjectName("task");
    progress_->setObjectName("progress");
    progress_->setRange(0, 1000);
    progress_->setFixedWidth(180);
    progress_->setTextVisible(false);
    auto* button = new QToolButton(this);
    button->setObjectName("cancelButton");
    button->setDefaultAction(&cancel);
    button->setAutoRaise(true);
    row->addWidget(task_);
    row->addWidget(progress_);
    row->addWidget(button);
    hide();
    for (JobRunner* runner : runners_) {
        connect(runner, &JobRunner::started, this, &WorkDisplay::showJob);
        // Queued, because QProgressBar::setValue() repaints the window at once, including the
        // views. When a job starts, some of these may not have handled the change yet.
        connect(runner, &JobRunner::started, this, &WorkDisplay::showFraction,
                Qt::QueuedConnection);
        connect(runner, &JobRunner::idle, this, &WorkDisplay::showJob);
        connect(runner, &JobRunner::progressed, this, &WorkDisplay::showFraction);
    }
}

JobRunner* WorkDisplay::busy() const {
    const auto found =
        std::ranges::find_if(runners_, [](const JobRunner* runner) { return runner->isBusy(); });
    return found == runners_.end() ? nullptr : *found;
}

void WorkDisplay::showJob() {
    const JobRunner* runner = busy();
    if (runner) {
        task_->setText(runner->title());
    }
    setVisible(runner != nullptr);
}

void WorkDisplay::showFraction() {
    if (const JobRunner* runner = busy()) {
        progress_->setValue(static_cast<int>(runner->fraction() * progress_->maximum()));
    }
}

}  // namespace toile::app
