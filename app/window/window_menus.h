// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

class QDockWidget;
class QMainWindow;
class QMenu;
class QWidget;

namespace toile::app {

class ActionRegistry;
class MaterialMenu;
class RecentFiles;
class Workspace;

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
