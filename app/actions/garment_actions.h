// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/actions/action_registry.h"
#include "app/actions/file_dialogs.h"
#include "app/jobs/job_runner.h"
#include "core/pattern/piece_grain.h"

namespace toile::app {

struct GrainShares;
class MaterialMenu;
class Preferences;
class PatternPrinting;
class ProjectActions;
class Workspace;

/// Implements the actions of the table that need a dialog or a job before they call the workspace.
/// Keeps the actions' state (enabled, checked) in step with the document.
class GarmentActions : public QObject {
    Q_OBJECT

public:
    /// @param window  parent of the dialogs. All must outlive this object.
    GarmentActions(ActionRegistry& actions, Workspace& workspace, Preferences& preferences,
                   QWidget& window);

    void setFileDialogs(FileDialogs dialogs) { dialogs_ = std::move(dialogs); }
    FileDialogs& fileDialogs() { return dialogs_; }
    Workspace& workspace() { return workspace_; }
    /// Saving and projects.
    ProjectActions& project() { return *project_; }
    /// Menu entries for the material of the selected pieces.
    MaterialMenu& materials() { return *materials_; }
    /// Opens a project or meshes that the user chose or dropped, and remembers the folder. Asks
    /// first if unsaved changes would be lost.
    void openFiles(const QStringList& files);
    void askAndOpen();
    void askAndExport();
    /// Exports the selected pieces only.
    void askAndExportThese();
    void askAndOpenReference();
    /// Opens a pattern to compare with, which the user chose or dropped.
    void openReference(const QString& file);
    void askAndPrint();
    void askAndReadSeams();
    void askAndWriteSeams();
    /// Saves a report of the proof. Requires a proof of the current pattern.
    void askAndSaveProof();
    /// Asks for the mesh on which the proof puts the pattern.
    void askForBody();
    void selectAll();
    void selectNone();
    void askForMaterial();
    /// Resets the ease of the selected seam to that of the garment.
    void resetEase();
    /// These act on the selected flat pieces, or on all.
    void findVerticalGrain() { findGrain(GrainRule::Vertical); }
    void findReferenceGrain() { findGrain(GrainRule::Reference); }
    void findBestGrain() { findGrain(GrainRule::LeastStrain); }
    void resetGrain();

signals:
    /// A request was refused; `sentence` explains why.
    void failed(const QString& sentence);
    /// A request succeeded, and nothing else in the window shows it.
    void done(const QString& sentence);

private:
    void connectState();
    void updateHistory();
    void follow(const DocumentChange* what = nullptr);
    void openNow(const QStringList& files);
    /// @param format  suggested extension  @param onlySelected  suggested, too
    void askAndExportAs(const QString& format, bool onlySelected = false);
    /// Shows the folder of a file in the file manager when the file is written.
    void showOnceWritten(const QString& path);
    QString folderToWriteTo() const;
    void findGrain(GrainRule rule);
    void sayOutdated();
    /// Reports what the best grain improves, with the same figure as the fabric panel.
    void sayWhatIsWon(const GrainShares& shares);

    ActionRegistry& actions_;
    Workspace& workspace_;
    Preferences& preferences_;
    QWidget& window_;
    FileDialogs dialogs_ = FileDialogs::native();
    ProjectActions* project_;
    PatternPrinting* printing_;
    MaterialMenu* materials_;
    JobRunner::Ticket grain_ = 0;  ///< finds the grain
};

}  // namespace toile::app
