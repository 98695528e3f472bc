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
    QString place{};  ///< menu path: "View ▸ Show"
    QString tip{};
    QString otherwise{};  ///< synonyms that the search finds, too
    QString keys{};
    QIcon icon{};
    bool enabled = true;
    bool listedUnasked = true;    ///< also listed if the field is empty
    std::function<void()> run{};  ///< required
};

struct FoundCommand {
    int command;               ///< index
    std::vector<int> letters;  ///< indices into its text to mark, ascending
};

/// The matching commands, best first, disabled ones last. Every typed word must match the text
/// (letters in order), or start a word of the path or of the tip. Order: words and word starts of
/// the text, then those of the path, adjacent letters, words of the tip, scattered letters. If
/// nothing is typed, returns the commands with `listedUnasked` in their order.
std::vector<FoundCommand> searchCommands(const std::vector<Command>& commands,
                                         const QString& typed);

/// How well typed letters match a text.
struct FuzzyMatch {
    int score = 0;               ///< larger is better
    std::vector<int> letters{};  ///< matched indices into the text, ascending
};

/// Matches the letters in order, with any text between them, ignoring case and accents. Word starts
/// and adjacent letters score more. Empty if a letter is missing; no letters match every text.
/// Cost: the product of the lengths.
std::optional<FuzzyMatch> fuzzyMatch(const QString& letters, const QString& text);

/// True if the letters start a word of the text, ignoring case and accents.
bool beginsWord(const QString& letters, const QString& text);

}  // namespace toile::app
