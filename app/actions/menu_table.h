// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <variant>
#include <vector>

#include "app/actions/action_registry.h"

namespace toile::app {

/// Which menu holds which actions: the table beside that of the actions, for the menu bar, for the
/// paths in the command palette and for the groups of the help page.

struct MenuSeparator {};
/// A line of text over what follows.
struct MenuHeading {
    const char* text;  ///< to be translated
};
/// Another menu of the table, by name.
struct Submenu {
    const char* name;
};
/// What the window fills in: the lists that can be shown.
struct ListsPlace {};

/// What the window fills in: the files that were opened last.
struct RecentPlace {};

/// What the window fills in: what pieces of the garment are cut from.
struct MaterialsPlace {};

using MenuItem = std::variant<ActionId, MenuSeparator, MenuHeading, Submenu, ListsPlace,
                              RecentPlace, MaterialsPlace>;

enum class MenuPlace { Bar, Submenu, Context };

struct MenuSpec {
    const char* name;   ///< object name
    const char* title;  ///< to be translated; of a context menu none is seen
    std::vector<MenuItem> items;
    MenuPlace place = MenuPlace::Bar;
};

/// In the order of the menu bar.
const std::vector<MenuSpec>& menuTable();
/// Titles and headings in the user's language, with mnemonic.
QString menuText(const char* text);

/// Where an action is found.
struct PlacedAction {
    ActionId id;
    QStringList menus;  ///< from the menu bar down, without mnemonics: "File", "Export pattern"
};

/// What a pattern maker can do without: ways to flatten that change seam lines or are there to be
/// compared with, overlays of the mathematics, and what is about the mesh.
bool isForSpecialists(ActionId id);

/// Every action of the menus in their order.
std::vector<PlacedAction> placedActions();

}  // namespace toile::app
