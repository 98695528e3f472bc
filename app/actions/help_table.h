// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QString>
#include <functional>
#include <vector>

#include "app/widgets/command_search.h"

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

class ActionRegistry;
class Document;

/// What the command palette offers at this time: every action, as it is enabled now; once something
/// is typed also the garment's pieces and seams.
/// @param showPiece, showSeam  what is done with one that is chosen
std::vector<Command> commandList(const ActionRegistry& actions, const Document& document,
                                 const std::function<void(int)>& showPiece,
                                 const std::function<void(int)>& showSeam);

}  // namespace toile::app
