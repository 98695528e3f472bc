// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

class QDockWidget;
class QMainWindow;

namespace toile::app {

class ActionRegistry;
class RecentFiles;
class Workspace;

/// The window's menus, from the tables of actions and menus. What is given must outlive the window.
/// @param lists  that can be shown
void fillMenuBar(QMainWindow& window, const ActionRegistry& actions,
                 const QList<QDockWidget*>& lists, RecentFiles& recent);
/// The toolbar; after the menus, of which it opens one.
void addToolBar(QMainWindow& window, const ActionRegistry& actions, Workspace& workspace);

}  // namespace toile::app
