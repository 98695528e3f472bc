// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QString>
#include <functional>
#include <vector>

#include "app/widgets/command_search.h"

namespace toile::app {

class ActionRegistry;

/// The help on keyboard and mouse, built from the tables of actions, menus and gestures.

struct HelpRow {
    QString keys;  ///< "Ctrl+Shift+Z, Ctrl+Y", "Drag"
    QString title;
    QString tip;  ///< empty for gestures
};

struct HelpGroup {
    QString title;
    std::vector<HelpRow> rows;  ///< never empty
};

/// Actions with a shortcut in menu order, then mouse gestures.
std::vector<HelpGroup> helpGroups(const ActionRegistry& actions,
                                  QKeySequence::SequenceFormat format);

class ActionRegistry;
class Document;

/// Commands of the palette: every action with its current state. Pieces and seams of the garment
/// are listed only when the user types.
/// @param showPiece, showSeam  called for a chosen piece or seam
std::vector<Command> commandList(const ActionRegistry& actions, const Document& document,
                                 const std::function<void(int)>& showPiece,
                                 const std::function<void(int)>& showSeam);

}  // namespace toile::app
