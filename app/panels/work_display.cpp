// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/work_display.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "app/jobs/job_runner.h"

namespace toile {

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
        // Later: a progress bar paints the window as it is set, the views with it, and a job may
        // start while some of these have yet to hear what changed.
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

}  // namespace toile
