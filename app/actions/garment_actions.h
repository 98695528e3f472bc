// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/actions/action_registry.h"
#include "app/actions/file_dialogs.h"
#include "app/document/document_change.h"

namespace toile {

class Preferences;
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
    /// Opens what the person has chosen or dropped, and remembers the folder.
    void openFiles(const QStringList& files);

signals:
    /// A wish could not be granted, and why.
    void failed(const QString& sentence);

private:
    void connectFiles();
    void connectSelection();
    void connectView();
    void connectFlattening();
    void connectSeams();
    void askAndOpen();
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
};

}  // namespace toile
