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
class PiecesPanel;
class Preferences;
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

    void openFiles(const QStringList& files);

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void makeCentre();
    void makeDocks();
    void makeMenus();
    void makeToolBar();
    void makeStatusBar();
    void connectJobs();
    void onChanged(DocumentChanges what);
    void showGarmentParts(bool shown);
    void updateTitle();
    void showAbout();

    Preferences& preferences_;
    Workspace workspace_;
    ActionRegistry actions_;
    GarmentActions* garmentActions_;
    QStackedWidget* pages_ = nullptr;
    ViewArea* views_ = nullptr;
    Banner* banner_ = nullptr;
    QDockWidget *piecesDock_ = nullptr, *messagesDock_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QLabel *task_ = nullptr, *hints_ = nullptr;
    QWidget* work_ = nullptr;  ///< task, progress and cancel button, there while a job runs
};

}  // namespace toile
