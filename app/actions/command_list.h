// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "app/widgets/command_search.h"

namespace toile::app {

class ActionRegistry;
class Document;

/// What the command palette offers at this time: every action, as it is enabled now; once something
/// is typed also the garment's pieces and seams.
/// @param showPiece, showSeam  what is done with one that is chosen
std::vector<Command> commandList(const ActionRegistry& actions, const Document& document,
                                 const std::function<void(int)>& showPiece,
                                 const std::function<void(int)>& showSeam);

}  // namespace toile::app
