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

/// Windows and dialogs that actions open: command palette, method comparison, marker, help,
/// preferences, and information about Toile.
class WindowDialogs : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object. Nothing is shown until an action asks for it.
    WindowDialogs(QWidget& window, Workspace& workspace, const ActionRegistry& actions,
                  ViewArea& views, Preferences& preferences, FileDialogs& files);
    ~WindowDialogs() override;

private:
    /// Opens the palette with all commands and the garment's pieces and seams.
    void showCommands();
    /// Opens the comparison; there is only one such window.
    void compareMethods();
    /// Opens the marker window; there is only one.
    void layOnCloth();
    void askWhatIsSmall();
    /// Opens the form beside the garment; there is only one.
    void prepareScan();
    /// Opens the form of proposed cuts. They are discarded when it closes.
    void showProposals();
    /// Moves a form over the pattern, so that the garment stays visible.
    void placeBeside(QWidget& form) const;
    void editPreferences();
    void showHelp();
    /// @param name  of a documentation page
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
