// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

class QAction;
class QLabel;
class QProgressBar;
class QStatusBar;
class QToolButton;

namespace toile::app {

class ActionRegistry;
class HintLabel;
class JobRunner;
class ProjectSession;
class ReadyChecker;
class Workspace;

/// Shows the running job, its progress and a button to cancel it; hidden if there is none.
class WorkDisplay : public QWidget {
    Q_OBJECT

public:
    /// @param runners  the first busy one is shown. All must outlive this object.
    WorkDisplay(std::vector<JobRunner*> runners, QAction& cancel, QWidget* parent = nullptr);

private:
    void showJob();
    void showFraction();
    JobRunner* busy() const;

    std::vector<JobRunner*> runners_;
    QLabel* task_;
    QProgressBar* progress_;
};

/// The status bar: mouse hints, a summary of the garment, running jobs and short messages.
class WindowStatus : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object. @param checker  counts the faults left in an export
    WindowStatus(QStatusBar& bar, Workspace& workspace, const ActionRegistry& actions,
                 ProjectSession& session, const ReadyChecker& checker);

    /// One line; omits clauses that do not fit.
    void setHint(const QString& hint);
    /// Shows a message for some seconds.
    void say(const QString& sentence);
    /// Updates height, unit and division of the garment.
    void updateSummary();
    /// True if the last update found a garment.
    bool hasSummary() const;

signals:
    /// The user clicked the summary.
    void summaryWanted();

private:
    QStatusBar& bar_;
    Workspace& workspace_;
    HintLabel* hint_;
    QToolButton* summary_;
};

}  // namespace toile::app
