// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/command_search.h"

#include <QStringList>
#include <algorithm>

#include "app/widgets/fuzzy_match.h"

namespace toile {

namespace {

/// A place or a tip is worth less than the least match of a text of three letters.
constexpr int kPlaceScore = 2, kTipScore = 1;

struct Candidate {
    FoundCommand found;
    bool enabled;
    int score;
};

/// @return false where a word fits nowhere
bool score(const Command& command, const QStringList& words, Candidate& candidate) {
    for (const QString& word : words) {
        if (const auto match = fuzzyMatch(word, command.text)) {
            candidate.score += match->score;
            auto& letters = candidate.found.letters;
            letters.insert(letters.end(), match->letters.begin(), match->letters.end());
        } else if (beginsWord(word, command.place) || beginsWord(word, command.otherwise)) {
            candidate.score += kPlaceScore;
        } else if (beginsWord(word, command.tip)) {
            candidate.score += kTipScore;
        } else {
            return false;
        }
    }
    auto& letters = candidate.found.letters;
    std::sort(letters.begin(), letters.end());
    letters.erase(std::unique(letters.begin(), letters.end()), letters.end());
    return true;
}

}  // namespace

std::vector<FoundCommand> searchCommands(const std::vector<Command>& commands,
                                         const QString& typed) {
    const QStringList words = typed.simplified().split(' ', Qt::SkipEmptyParts);
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        Candidate candidate{{static_cast<int>(i), {}}, commands[i].enabled, 0};
        if ((!words.isEmpty() || commands[i].listedUnasked) &&
            score(commands[i], words, candidate)) {
            candidates.push_back(std::move(candidate));
        }
    }
    std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
        return a.enabled != b.enabled ? a.enabled : a.score > b.score;
    });
    std::vector<FoundCommand> found;
    found.reserve(candidates.size());
    for (Candidate& candidate : candidates) {
        found.push_back(std::move(candidate.found));
    }
    return found;
}

}  // namespace toile
