// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>

#include "app/actions/action_registry.h"
#include "app/actions/workspace.h"

class QDockWidget;
class QLabel;
class QProgressBar;
class QStackedWidget;

namespace toile {

class Banner;
class GarmentActions;
class GarmentCard;
class MessagesPanel;
class PiecesPanel;
class Preferences;
class SeamsPanel;
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
    GarmentActions& garmentActions() { return *garmentActions_; }
    ViewArea& views() { return *views_; }
    Banner& banner() { return *banner_; }
    GarmentCard& card() { return *card_; }

    void openFiles(const QStringList& files);
    /// Brings a list to the front and moves the keyboard there.
    void goTo(Panel panel);

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void makeCentre();
    void makeDocks();
    QDockWidget* makeDock(const QString& title, const char* name, QWidget* panel);
    void makeMenus();
    void makeFlattenMenu();
    void makeGarmentMenu();
    void makeViewMenu();
    void makeToolBar();
    void makeStatusBar();
    void makeWorkDisplay();
    void connectJobs();
    void connectPanels();
    void onChanged(DocumentChanges what);
    void showGarmentParts(bool shown);
    void updateTitle();
    void updateSummary();
    void askAboutGarment();
    void showAbout();

    Preferences& preferences_;
    Workspace workspace_;
    ActionRegistry actions_;
    GarmentActions* garmentActions_;
    QStackedWidget* pages_ = nullptr;
    ViewArea* views_ = nullptr;
    Banner* banner_ = nullptr;
    GarmentCard* card_ = nullptr;
    PiecesPanel* pieces_ = nullptr;
    SeamsPanel* seams_ = nullptr;
    MessagesPanel* messages_ = nullptr;
    QDockWidget *piecesDock_ = nullptr, *seamsDock_ = nullptr, *messagesDock_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QLabel *task_ = nullptr, *hints_ = nullptr;
    QLabel* summary_ = nullptr;     ///< height, unit and division of the garment
    QWidget* work_ = nullptr;       ///< task, progress and cancel button, there while a job runs
    Workspace::Paths keptGuesses_;  ///< files whose guesses the person has found right
};

}  // namespace toile
