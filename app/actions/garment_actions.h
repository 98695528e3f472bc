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

/// What the actions of the table work with: the workspace, and what has to ask or to wait before it
/// hands requests to it. Keeps the actions' state (can be done, on, chosen) as the document is.
class GarmentActions : public QObject {
    Q_OBJECT

public:
    /// @param window parent of the dialogs. All must outlive this object.
    GarmentActions(ActionRegistry& actions, Workspace& workspace, Preferences& preferences,
                   QWidget& window);

    void setFileDialogs(FileDialogs dialogs) { dialogs_ = std::move(dialogs); }
    FileDialogs& fileDialogs() { return dialogs_; }
    Workspace& workspace() { return workspace_; }
    /// Saving and projects.
    ProjectActions& project() { return *project_; }
    /// What the selected pieces are cut from.
    MaterialMenu& materials() { return *materials_; }
    /// Opens what the person has chosen or dropped, a project or meshes, and remembers the folder.
    /// Asks first where changes would be lost.
    void openFiles(const QStringList& files);
    void askAndOpen();
    void askAndExport();
    /// The selected pieces alone.
    void askAndExportThese();
    void askAndOpenReference();
    /// Opens a pattern to compare with, that the person has chosen or dropped.
    void openReference(const QString& file);
    void askAndPrint();
    void askAndReadSeams();
    void askAndWriteSeams();
    /// What sewing the pattern has shown, as a report. Requires a proof of the present pattern.
    void askAndSaveProof();
    /// For the mesh that the pattern is to be worn on when it is proved.
    void askForBody();
    void selectAll();
    void selectNone();
    void askForMaterial();
    /// The ease of the selected seam is that of the garment again.
    void resetEase();
    /// For the selected pieces that are flat, or for all.
    void findVerticalGrain() { findGrain(GrainRule::Vertical); }
    void findReferenceGrain() { findGrain(GrainRule::Reference); }
    void findBestGrain() { findGrain(GrainRule::LeastStrain); }
    void resetGrain();

signals:
    /// A request was refused, and why.
    void failed(const QString& sentence);
    /// A request was met, which nothing else in the window shows.
    void done(const QString& sentence);

private:
    void connectState();
    void updateHistory();
    void followAll();
    void openNow(const QStringList& files);
    /// @param format  suggested, by its ending  @param onlySelected  suggested, too
    void askAndExportAs(const QString& format, bool onlySelected = false);
    /// The folder of a file that is being written, on the desktop.
    void showOnceWritten(const QString& path);
    QString folderToWriteTo() const;
    void findGrain(GrainRule rule);
    void sayOutdated();
    /// Of the best grain, in the figure that is shown beside the fabric.
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
