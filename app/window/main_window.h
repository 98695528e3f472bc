// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <QWidget>
#include <memory>
#include <optional>

#include "app/actions/action_registry.h"
#include "app/session/workspace.h"
#include "app/window/recovery.h"
#include "app/window/window_centre.h"
#include "app/window/window_docks.h"

namespace toile::app {

class GarmentActions;
class WindowContextMenus;
class WindowDialogs;
class WindowStatus;

enum class PatternAge;

/// Over the pattern view, while edits wait to be flattened: says that the pattern is out of date,
/// with a button that flattens it. Export and printing say so too.
class OutdatedBar : public QWidget {
    Q_OBJECT

public:
    /// @param view  where it lies; owns it. The others must outlive this.
    OutdatedBar(Workspace& workspace, const ActionRegistry& actions, QWidget& view);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void follow(PatternAge age);
    void placeIt();

    Workspace& workspace_;
    const ActionRegistry& actions_;
    QString exportTip_, printTip_;  ///< of the actions, where nothing is wrong
};

struct Choices;

/// Puts the parts together, each of which owns what it does: the centre with the views, the docks,
/// the status bar, the dialogs; menus and toolbar. Holds no garment state.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    /// `preferences` must outlive the window.
    explicit MainWindow(Preferences& preferences, QWidget* parent = nullptr);
    ~MainWindow() override;

    Workspace& workspace() { return workspace_; }
    ActionRegistry& actions() { return actions_; }
    ToolBox& tools() { return *tools_; }
    GarmentActions& garmentActions() { return *garmentActions_; }
    ViewArea& views() { return centre_->views(); }
    Banner& banner() { return centre_->banner(); }
    GarmentCard& card() { return centre_->card(); }
    ReadyChecker& checker() { return docks_->checker(); }

    void openFiles(const QStringList& files);
    /// Keeps recovery files of unsaved changes, and offers those that a crash has left there.
    /// @param times  none: as often as the person prefers, now and later
    Recovery& keepRecoveryFiles(const QString& folder,
                                const std::optional<AutosaveTimes>& times = {});
    /// Brings a list to the front and moves the keyboard there.
    void goTo(Panel panel);

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void connectParts();
    void onChanged(const DocumentChange& what);
    void showGarmentParts(bool shown);
    void updateTitle();
    void updateHint();
    /// Heavy garments begin without flattening after every edit.
    void adaptToWeight();
    /// Applies the user's choices. @param before  to see what has changed
    void followChoices(const Choices& before);
    /// Asks where changes would be lost, and waits for files that are being written.
    bool mayClose();

    Preferences& preferences_;
    Workspace workspace_;
    ActionRegistry actions_;
    std::unique_ptr<GarmentActions> garmentActions_;
    std::unique_ptr<ToolBox> tools_;
    std::unique_ptr<WindowCentre> centre_;
    std::unique_ptr<WindowDocks> docks_;
    std::unique_ptr<WindowStatus> status_;
    std::unique_ptr<WindowDialogs> dialogs_;
    std::unique_ptr<WindowContextMenus> contextMenus_;
    std::unique_ptr<Recovery> recovery_;
    bool closingAnyway_ = false;  ///< nothing is to be asked any more
};

}  // namespace toile::app
