// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>
#include <functional>
#include <vector>

namespace toile {

/// One line of the command palette.
struct Command {
    QString text;
    QString place{};  ///< where it is found otherwise: "View ▸ Show"
    QString tip{};
    QString otherwise{};  ///< what else it is called: it is found by these words too
    QString keys{};
    QIcon icon{};
    bool enabled = true;
    bool listedUnasked = true;    ///< also while nothing is typed
    std::function<void()> run{};  ///< required
};

struct FoundCommand {
    int command;               ///< index
    std::vector<int> letters;  ///< places in its text to mark, rising
};

/// The commands that fit what was typed, best first, those that cannot be run now last. Every word
/// has to fit the text (letters in order), or begin a word of its place or its tip, which counts
/// less. While nothing is typed: those that are listed unasked, in their order.
std::vector<FoundCommand> searchCommands(const std::vector<Command>& commands,
                                         const QString& typed);

}  // namespace toile
