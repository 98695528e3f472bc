// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

class QAction;
class QLabel;
class QProgressBar;

namespace toile {

class JobRunner;

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

}  // namespace toile
