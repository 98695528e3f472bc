// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <variant>
#include <vector>

#include "app/actions/action_registry.h"

namespace toile::app {

/// The actions of every menu. The table defines the menu bar, the paths in the command palette and
/// the groups of the help page.

struct MenuSeparator {};
/// A line of text above the following items.
struct MenuHeading {
    const char* text;  ///< to be translated
};
/// Another menu of the table, by name.
struct Submenu {
    const char* name;
};
/// Placeholder that the window fills with the dock toggles.
struct ListsPlace {};

/// Placeholder that the window fills with recent files.
struct RecentPlace {};

/// Placeholder that the window fills with the materials of the garment.
struct MaterialsPlace {};

using MenuItem = std::variant<ActionId, MenuSeparator, MenuHeading, Submenu, ListsPlace,
                              RecentPlace, MaterialsPlace>;

enum class MenuPlace { Bar, Submenu, Context };

struct MenuSpec {
    const char* name;   ///< object name
    const char* title;  ///< to be translated; not shown for context menus
    std::vector<MenuItem> items;
    MenuPlace place = MenuPlace::Bar;
};

/// In the order of the menu bar.
const std::vector<MenuSpec>& menuTable();
/// Titles and headings in the user's language, with mnemonic.
QString menuText(const char* text);

/// The menu path of an action.
struct PlacedAction {
    ActionId id;
    QStringList menus;  ///< from the menu bar down, without mnemonics: "File", "Export pattern"
};

/// True for actions that a pattern maker does not need: mesh repairs, mathematical overlays, and
/// methods that change seam lines or serve for comparison.
bool isForSpecialists(ActionId id);

/// All menu actions in menu order.
std::vector<PlacedAction> placedActions();

}  // namespace toile::app
