// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <array>

#include "app/actions/action_table.h"

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;
class QToolBar;
class QToolButton;
class QWidget;

namespace toile::app {

class ActionRegistry;
class MaterialMenu;
class RecentFiles;
class Workspace;

/// The overlays in the toolbar: a button that shows the one that is on and opens a list of all, and
/// one button for each of the two that were on last.
class OverlayButtons : public QObject {
    Q_OBJECT

public:
    /// Adds them at the bar's end. Actions and bar must outlive this.
    OverlayButtons(QToolBar& bar, const ActionRegistry& actions);

private:
    static constexpr std::size_t kLast = 2;

    void follow();
    void show();

    QList<QAction*> overlays_;
    QAction* shown_ = nullptr;
    std::array<QAction*, kLast> last_;  ///< the latest first
    QToolButton* choice_;
    std::array<QToolButton*, kLast> buttons_;
};

/// The window's menus, from the tables of actions and menus. What is given must outlive the window.
/// @param lists  that can be shown
void fillMenuBar(QMainWindow& window, const ActionRegistry& actions,
                 const QList<QDockWidget*>& lists, RecentFiles& recent, MaterialMenu& materials);
/// The toolbar; after the menus, of which it opens one.
void addToolBar(QMainWindow& window, const ActionRegistry& actions, Workspace& workspace);
/// One of the table's menus, to be shown where something is pointed at; the caller's.
QMenu* makeContextMenu(const char* name, const ActionRegistry& actions, MaterialMenu& materials,
                       QWidget* parent);

}  // namespace toile::app
