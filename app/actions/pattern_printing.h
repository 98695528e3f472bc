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

/// Prints the pattern: asks for paper and printer, then prints in a job that can be cancelled.
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
    /// The user wants a PDF file instead, with the stored options.
    void fileWanted(bool onlySelected);

private:
    void showPattern(PrintDialog& dialog, const std::set<int>& only);
    void printFrom(PrintDialog& dialog);

    Workspace& workspace_;
    Preferences& preferences_;
    const FileDialogs& dialogs_;
    QWidget& window_;
    JobRunner::Ticket drawing_ = 0;  ///< job that draws the pattern for the dialog
};

}  // namespace toile::app
