// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

namespace toile::app {

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
/// has to fit the text (letters in order), or begin a word of its place or its tip. Words and
/// beginnings of words of the text come first, then those of the place, letters together, words of
/// the tip, scattered letters. While nothing is typed: those that are listed unasked, in their
/// order.
std::vector<FoundCommand> searchCommands(const std::vector<Command>& commands,
                                         const QString& typed);

/// How well typed letters fit a text.
struct FuzzyMatch {
    int score = 0;               ///< larger is better
    std::vector<int> letters{};  ///< places in the text that were matched, rising
};

/// The letters in this order, whatever stands between them; case and accents do not count.
/// Beginnings of words and letters that follow each other score more. Nothing where a letter is
/// missing; no letters fit everything. Cost: the product of the lengths.
std::optional<FuzzyMatch> fuzzyMatch(const QString& letters, const QString& text);

/// True where the letters begin a word of the text; case and accents do not count.
bool beginsWord(const QString& letters, const QString& text);

}  // namespace toile::app
