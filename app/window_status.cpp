// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window_status.h"

#include <QLabel>
#include <QStatusBar>

#include "app/actions/action_registry.h"
#include "app/actions/project_session.h"
#include "app/actions/workspace.h"
#include "app/jobs/ready_checker.h"
#include "app/panels/garment_summary.h"
#include "app/panels/problem_text.h"
#include "app/panels/work_display.h"
#include "app/settings/length_display.h"
#include "app/widgets/hint_label.h"

namespace toile {

namespace {

constexpr int kMessageMilliseconds = 6000;
/// As long as a sentence with a number takes to read.
constexpr int kWrittenMilliseconds = 10000;

}  // namespace

WindowStatus::WindowStatus(QStatusBar& bar, Workspace& workspace, const ActionRegistry& actions,
                           ProjectSession& session, const ReadyChecker& checker)
    : bar_(bar), workspace_(workspace), hint_(new HintLabel), summary_(new QLabel) {
    hint_->setObjectName("toolHint");
    hint_->setContentsMargins(8, 0, 8, 0);
    hint_->setMinimumWidth(60);
    bar_.addWidget(hint_, 1);
    summary_->setObjectName("garmentSummary");
    summary_->setContentsMargins(8, 0, 8, 0);
    bar_.addPermanentWidget(summary_);
    bar_.addPermanentWidget(
        new WorkDisplay({&workspace.jobs(), &workspace.writing()}, actions[ActionId::Cancel]));
    for (JobRunner* jobs : {&workspace.jobs(), &workspace.writing()}) {
        connect(jobs, &JobRunner::cancelled, this, [this](const QString& title, bool replaced) {
            if (!replaced) {
                say(tr("%1: cancelled").arg(title));
            }
        });
    }
    connect(&session, &ProjectSession::saved, this,
            [this](const QString& path) { say(tr("Saved: %1").arg(path)); });
    connect(&workspace, &Workspace::exported, this, [this, &checker](const QString& path) {
        const int faults = checker.readiness().count(Severity::Fault);
        bar_.showMessage(faults == 0 ? tr("Written: %1").arg(path)
                                     : tr("Written: %1 (%2 left, see Problems)")
                                           .arg(path, severityCount(Severity::Fault, faults)),
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
    summary_->setText(garmentSummary(workspace_.document()));
    summary_->setToolTip(garmentReasons(workspace_.document()));
}

bool WindowStatus::hasSummary() const {
    return !summary_->text().isEmpty();
}

}  // namespace toile
