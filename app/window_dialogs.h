// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/widgets/command_palette.h"

namespace toile {

class ActionRegistry;
class CompareWindow;
class Preferences;
class ViewArea;
class Workspace;

/// What the window opens beside its own work: the command palette, the comparison of methods, help,
/// preferences, and what Toile is.
class WindowDialogs : public QObject {
    Q_OBJECT

public:
    /// All must outlive this.
    WindowDialogs(QWidget& window, Workspace& workspace, const ActionRegistry& actions,
                  ViewArea& views, Preferences& preferences);
    ~WindowDialogs() override;

private:
    void showCommands();
    void compareMethods();
    void editPreferences();
    void showHelp();
    void showAbout();

    QWidget& window_;
    Workspace& workspace_;
    const ActionRegistry& actions_;
    ViewArea& views_;
    Preferences& preferences_;
    CommandPalette palette_;
    CompareWindow* compare_ = nullptr;
};

}  // namespace toile
