// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <array>
#include <optional>

#include "app/actions/action_registry.h"
#include "app/actions/autosave.h"
#include "app/actions/workspace.h"
#include "app/views/tools/tool_view.h"

class QDockWidget;
class QLabel;
class QStackedWidget;
class QUndoView;

namespace toile {

class Banner;
class CommandPalette;
class CompareWindow;
class FabricPanel;
class GarmentActions;
class GarmentCard;
class HintLabel;
class PiecesPanel;
class PositionPanel;
class Preferences;
class ProblemsPanel;
class ReadyChecker;
class Recovery;
class RecoveryCard;
class SeamsPanel;
class ToolBox;
class ViewArea;

/// Puts the parts together: menus, toolbar, views, panels, status bar. Holds no garment state.
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
    ViewArea& views() { return *views_; }
    Banner& banner() { return *banner_; }
    GarmentCard& card() { return *card_; }
    ReadyChecker& checker() { return *checker_; }

    void openFiles(const QStringList& files);
    /// Keeps recovery files of unsaved changes, and offers those that a crash has left there.
    /// As often as the person prefers, now and later.
    Recovery& keepRecoveryFiles(const QString& folder);
    /// The same at other times.
    Recovery& keepRecoveryFiles(const QString& folder, const AutosaveTimes& times);
    /// Brings a list to the front and moves the keyboard there.
    void goTo(Panel panel);

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    /// Of the docks and their arrangement: what another version has kept is left alone.
    static constexpr int kLayoutVersion = 1;

    void makeCentre();
    void makeDocks();
    void makeProblems();
    QDockWidget* makeDock(const QString& title, const char* name, QWidget* panel);
    void makePropertyDocks();
    void arrangeDocks();
    void showDocks();
    std::array<QDockWidget*, 6> docks() const;
    void makeMenus();
    void makeToolBar();
    void connectTools();
    QWidget* makeToolPalette();
    void makeStatusBar();
    void connectJobs();
    void connectLooks();
    void connectPanels();
    void connectShell();
    void connectChecks();
    void onChanged(DocumentChanges what);
    /// Selects and frames what these findings of the checker are about.
    void showFindings(const QList<int>& indices);
    void showGarmentParts(bool shown);
    void updateTitle();
    void updateSummary();
    void askAboutGarment();
    void updateHint();
    /// Heavy garments begin without flattening after every edit.
    void adaptToWeight();
    void showCommands();
    void compareMethods();
    void editPreferences();
    void showHelp();
    void resetLayout();
    void followLengthUnit();
    void followColours();
    void showAbout();
    /// Asks where changes would be lost, and waits for files that are being written.
    bool mayClose();
    Recovery& startRecovery(const QString& folder, const std::optional<AutosaveTimes>& times);

    Preferences& preferences_;
    Workspace workspace_;
    ActionRegistry actions_;
    GarmentActions* garmentActions_;
    ToolBox* tools_;
    QStackedWidget* pages_ = nullptr;
    ViewArea* views_ = nullptr;
    Banner* banner_ = nullptr;
    GarmentCard* card_ = nullptr;
    CommandPalette* palette_ = nullptr;
    CompareWindow* compare_ = nullptr;
    RecoveryCard* recoveryCard_ = nullptr;
    Recovery* recovery_ = nullptr;
    PiecesPanel* pieces_ = nullptr;
    SeamsPanel* seams_ = nullptr;
    ReadyChecker* checker_ = nullptr;
    ProblemsPanel* problems_ = nullptr;
    PositionPanel* position_ = nullptr;
    FabricPanel* fabric_ = nullptr;
    QUndoView* history_ = nullptr;
    QDockWidget *piecesDock_ = nullptr, *seamsDock_ = nullptr, *problemsDock_ = nullptr,
                *historyDock_ = nullptr, *positionDock_ = nullptr, *fabricDock_ = nullptr;
    HintLabel* hints_ = nullptr;
    QLabel* summary_ = nullptr;  ///< height, unit and division of the garment
    ViewKind viewInUse_ = ViewKind::Garment;
    bool closingAnyway_ = false;    ///< nothing is to be asked any more
    Workspace::Paths keptGuesses_;  ///< files whose guesses the person has found right
};

}  // namespace toile
