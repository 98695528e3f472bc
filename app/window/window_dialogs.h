// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/widgets/command_palette.h"

namespace toile::app {

class ActionRegistry;
class CompareWindow;
struct FileDialogs;
class MarkerWindow;
class Preferences;
class ViewArea;
class Workspace;

/// What the window opens beside its own work: the command palette, the comparison of methods, help,
/// preferences, and what Toile is.
class WindowDialogs : public QObject {
    Q_OBJECT

public:
    /// All must outlive this. Nothing is shown before it is asked for.
    WindowDialogs(QWidget& window, Workspace& workspace, const ActionRegistry& actions,
                  ViewArea& views, Preferences& preferences, FileDialogs& files);
    ~WindowDialogs() override;

private:
    /// The palette, with what can be done now and the garment's pieces and seams.
    void showCommands();
    /// One window, however often it is asked for.
    void compareMethods();
    /// The same of laying the pieces on cloth.
    void layOnCloth();
    void askWhatIsSmall();
    /// One form, however often it is asked for, beside the garment.
    void prepareScan();
    /// The same of proposed cuts, which live while it is there.
    void showProposals();
    /// Over the pattern: the garment is to be seen.
    void placeBeside(QWidget& form) const;
    void editPreferences();
    void showHelp();
    /// @param name  of a page of the documentation
    void showPage(const QString& name);
    void reportProblem();
    void showAbout();

    QWidget& window_;
    Workspace& workspace_;
    const ActionRegistry& actions_;
    ViewArea& views_;
    Preferences& preferences_;
    FileDialogs& files_;
    CommandPalette palette_;
    CompareWindow* compare_ = nullptr;
    MarkerWindow* marker_ = nullptr;
};

}  // namespace toile::app
