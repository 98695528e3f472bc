// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <set>

#include "app/jobs/job_runner.h"

class QWidget;

namespace toile::app {

class Preferences;
class PrintDialog;
class Workspace;
struct FileDialogs;

/// Prints the pattern: asks for the paper, then for the printer, and leaves the work to a job that
/// can be cancelled.
class PatternPrinting : public QObject {
    Q_OBJECT

public:
    /// @param window  parent of the dialogs. All must outlive this object.
    PatternPrinting(Workspace& workspace, Preferences& preferences, const FileDialogs& dialogs,
                    QWidget& window, QObject* parent);

    /// Requires Workspace::canExport.
    void ask();

signals:
    void printed(const QString& sentence);
    void failed(const QString& sentence);
    /// A PDF file is wanted instead, with the options that are remembered.
    void fileWanted(bool onlySelected);

private:
    void showPattern(PrintDialog& dialog, const std::set<int>& only);
    void printFrom(PrintDialog& dialog);

    Workspace& workspace_;
    Preferences& preferences_;
    const FileDialogs& dialogs_;
    QWidget& window_;
    JobRunner::Ticket drawing_ = 0;  ///< of the pattern, for the dialog
};

}  // namespace toile::app
