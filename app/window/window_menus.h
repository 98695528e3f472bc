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

/// Overlay buttons of the toolbar: one that shows the active overlay and opens a list of all, and
/// one for each of the two previous overlays.
class OverlayButtons : public QObject {
    Q_OBJECT

public:
    /// Adds the buttons at the end of the bar. Actions and bar must outlive this object.
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

/// Fills the menu bar from the tables of actions and menus. The arguments must outlive the window.
/// @param lists  docks that the user can show
void fillMenuBar(QMainWindow& window, const ActionRegistry& actions,
                 const QList<QDockWidget*>& lists, RecentFiles& recent, MaterialMenu& materials);
/// Call it after fillMenuBar(), because a button opens one of the menus.
void addToolBar(QMainWindow& window, const ActionRegistry& actions, Workspace& workspace);
/// Creates a context menu of the table; the caller owns it.
QMenu* makeContextMenu(const char* name, const ActionRegistry& actions, MaterialMenu& materials,
                       QWidget* parent);

}  // namespace toile::app
