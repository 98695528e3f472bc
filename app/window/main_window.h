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

/// Bar over the pattern view, shown while edits wait to be flattened, with a button that flattens
/// them. The tool tips of export and printing warn, too.
class OutdatedBar : public QWidget {
    Q_OBJECT

public:
    /// @param view  parent, which owns the bar. The others must outlive it.
    OutdatedBar(Workspace& workspace, const ActionRegistry& actions, QWidget& view);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void follow(PatternAge age);
    void placeIt();

    Workspace& workspace_;
    const ActionRegistry& actions_;
    QString exportTip_, printTip_;  ///< of the actions, if the pattern is up to date
};

struct Choices;

/// Connects the parts of the window, each of which owns its work: the centre with the views, docks,
/// status bar, dialogs, menus and toolbar. Holds no garment state.
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
    /// Writes recovery files of unsaved changes, and offers those that a crash has left.
    /// @param times  none: follows the user's preference, now and later
    Recovery& keepRecoveryFiles(const QString& folder,
                                const std::optional<AutosaveTimes>& times = {});
    /// Brings a dock to the front and gives it the keyboard focus.
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
    /// Switches automatic flattening off for garments with many triangles.
    void adaptToWeight();
    /// Applies the user's choices. @param before  the previous ones, to find changes
    void followChoices(const Choices& before);
    /// Asks if changes would be lost, and waits for files that are being written.
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
    bool closingAnyway_ = false;  ///< do not ask again
};

}  // namespace toile::app
