// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/actions/action_registry.h"
#include "app/actions/file_dialogs.h"
#include "app/document/document_change.h"

namespace toile {

class Preferences;
class ProjectActions;
class Workspace;

/// What the actions do to the garment: asks where it must, hands the wish to the workspace, and
/// keeps the actions' state (on, off, chosen) as the document is.
class GarmentActions : public QObject {
    Q_OBJECT

public:
    /// @param window parent of the dialogs. All must outlive this object.
    GarmentActions(ActionRegistry& actions, Workspace& workspace, Preferences& preferences,
                   QWidget& window);

    void setFileDialogs(FileDialogs dialogs) { dialogs_ = std::move(dialogs); }
    FileDialogs& fileDialogs() { return dialogs_; }
    /// Saving and projects.
    ProjectActions& project() { return *project_; }
    /// Opens what the person has chosen or dropped, a project or meshes, and remembers the folder.
    /// Asks first where changes would be lost.
    void openFiles(const QStringList& files);

signals:
    /// A wish could not be granted, and why.
    void failed(const QString& sentence);

private:
    void connectFiles();
    void connectHistory();
    void updateHistory();
    void connectSelection();
    void connectView();
    void connectFlattening();
    void connectSeams();
    void askAndOpen();
    void openNow(const QStringList& files);
    void askAndReadSeams();
    void askAndWriteSeams();
    void askAndExport(const QString& suffix, const QString& filter);
    void onChanged(DocumentChanges what);
    void updateEnabled();

    ActionRegistry& actions_;
    Workspace& workspace_;
    Preferences& preferences_;
    QWidget& window_;
    FileDialogs dialogs_ = FileDialogs::native();
    ProjectActions* project_;
};

}  // namespace toile
