// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QString>
#include <vector>

namespace toile::app {

class ActionRegistry;

/// The help on keyboard and mouse, made of the tables of actions, menus and gestures.

struct HelpRow {
    QString keys;  ///< "Ctrl+Shift+Z, Ctrl+Y", "Drag"
    QString title;
    QString tip;  ///< empty for gestures
};

struct HelpGroup {
    QString title;
    std::vector<HelpRow> rows;  ///< never empty
};

/// Actions that have a key, by menu and in its order, then what the mouse does.
std::vector<HelpGroup> helpGroups(const ActionRegistry& actions,
                                  QKeySequence::SequenceFormat format);

}  // namespace toile::app
