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

/// What is being done, how far it is, and a button to stop it; hidden while nothing is.
class WorkDisplay : public QWidget {
    Q_OBJECT

public:
    /// @param runners  of those that are busy the first is shown. All must outlive this.
    WorkDisplay(std::vector<JobRunner*> runners, QAction& cancel, QWidget* parent = nullptr);

private:
    void showJob();
    void showFraction();
    JobRunner* busy() const;

    std::vector<JobRunner*> runners_;
    QLabel* task_;
    QProgressBar* progress_;
};

/// The status bar: what the mouse does, what the garment is, what is being done, and for a moment
/// what has been done.
class WindowStatus : public QObject {
    Q_OBJECT

public:
    /// All must outlive this. @param checker  knows what is left to repair in what is exported
    WindowStatus(QStatusBar& bar, Workspace& workspace, const ActionRegistry& actions,
                 ProjectSession& session, const ReadyChecker& checker);

    /// One line; clauses that do not fit are left out.
    void setHint(const QString& hint);
    /// For some seconds.
    void say(const QString& sentence);
    /// Height, unit and division of the garment, as they are now.
    void updateSummary();
    /// Whether anything was known of the garment then.
    bool hasSummary() const;

signals:
    /// The text about the garment has changed.
    void summaryWanted();

private:
    QStatusBar& bar_;
    Workspace& workspace_;
    HintLabel* hint_;
    QToolButton* summary_;
};

}  // namespace toile::app
