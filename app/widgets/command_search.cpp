// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/command_search.h"

#include <QStringList>
#include <algorithm>
#include <limits>
#include <tuple>

namespace toile::app {

namespace {

constexpr int kNone = std::numeric_limits<int>::min() / 2;
constexpr int kLetter = 1, kFollows = 5, kWordBegins = 8, kTextBegins = 3, kSkipped = 4;

/// Lower case without accents, one character for each of the text.
QString folded(const QString& text) {
    QString plain = text;
    for (QChar& letter : plain) {
        const QString parts = QString(letter).normalized(QString::NormalizationForm_KD);
        letter = (parts.isEmpty() ? letter : parts.front()).toCaseFolded();
    }
    return plain;
}

bool beginsWordAt(const QString& text, qsizetype at) {
    return text[at].isLetterOrNumber() && (at == 0 || !text[at - 1].isLetterOrNumber());
}

/// True if fewer than half of the places start a word or follow the previous one.
bool isScattered(const std::vector<int>& places, const QString& text) {
    std::size_t telling = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const bool follows = i > 0 && places[i] == places[i - 1] + 1;
        telling += follows || beginsWordAt(text, places[i]) ? 1 : 0;
    }
    return 2 * telling < places.size();
}

/// How well a typed word matches, best last. Written-out words rank above scattered letters.
enum class Fit { Scattered, TipBegins, Together, PlaceBegins, TextBegins, TextWord };

struct Candidate {
    FoundCommand found;
    bool enabled;
    Fit fit = Fit::TextWord;  ///< of the word that matches worst
    int score = 0;
    qsizetype length = 0;  ///< of equal matches the shortest wins
};

/// True if every letter but the first starts a word or follows the previous one.
bool areTogether(const std::vector<int>& places, const QString& text) {
    for (std::size_t i = 1; i < places.size(); ++i) {
        if (places[i] != places[i - 1] + 1 && !beginsWordAt(text, places[i])) {
            return false;
        }
    }
    return true;
}

/// True if the letters are one or more whole words of the text.
bool isWord(const QString& letters, const QString& text) {
    const QString wanted = folded(letters), given = folded(text);
    for (auto at = given.indexOf(wanted); at >= 0; at = given.indexOf(wanted, at + 1)) {
        const auto end = at + wanted.size();
        if (at < given.size() && beginsWordAt(given, at) &&
            (end == given.size() || !given[end].isLetterOrNumber())) {
            return true;
        }
    }
    return false;
}

/// Empty if the word does not match.
std::optional<Fit> fitOf(const QString& word, const Command& command,
                         const std::optional<FuzzyMatch>& inText) {
    if (inText && beginsWord(word, command.text)) {
        return isWord(word, command.text) ? Fit::TextWord : Fit::TextBegins;
    }
    if (beginsWord(word, command.place) || beginsWord(word, command.otherwise)) {
        return Fit::PlaceBegins;
    }
    if (inText && areTogether(inText->letters, command.text)) {
        return Fit::Together;
    }
    if (beginsWord(word, command.tip)) {
        return Fit::TipBegins;
    }
    return inText ? std::optional(Fit::Scattered) : std::nullopt;
}

/// @return false if a word does not match
bool score(const Command& command, const QStringList& words, Candidate& candidate) {
    for (const QString& word : words) {
        const auto match = fuzzyMatch(word, command.text);
        const auto fit = fitOf(word, command, match);
        if (!fit) {
            return false;
        }
        candidate.fit = std::min(candidate.fit, *fit);
        if (match) {
            candidate.score += match->score;
            auto& letters = candidate.found.letters;
            letters.insert(letters.end(), match->letters.begin(), match->letters.end());
        }
    }
    candidate.length = words.isEmpty() ? 0 : command.text.size();
    auto& letters = candidate.found.letters;
    std::sort(letters.begin(), letters.end());
    letters.erase(std::unique(letters.begin(), letters.end()), letters.end());
    return true;
}

}  // namespace

std::optional<FuzzyMatch> fuzzyMatch(const QString& letters, const QString& text) {
    const QString wanted = folded(letters), given = folded(text);
    const auto rows = static_cast<std::size_t>(wanted.size());
    const auto columns = static_cast<std::size_t>(given.size());
    if (rows == 0) {
        return FuzzyMatch{};
    }
    // best[i][j]: best score of letters 0..i with letter i at j. from[i][j]: place of letter i - 1
    // in that match.
    std::vector<std::vector<int>> best(rows, std::vector<int>(columns, kNone)), from = best;
    for (std::size_t i = 0; i < rows; ++i) {
        int before = i == 0 ? 0 : kNone, beforeAt = -1;  // best of letter i - 1 before place j - 1
        for (std::size_t j = 0; j < columns; ++j) {
            if (i > 0 && j > 1 && best[i - 1][j - 2] > before) {
                before = best[i - 1][j - 2];
                beforeAt = static_cast<int>(j) - 2;
            }
            if (wanted[qsizetype(i)] != given[qsizetype(j)]) {
                continue;
            }
            const int own = kLetter + (beginsWordAt(given, qsizetype(j)) ? kWordBegins : 0) +
                            (j == 0 ? kTextBegins : 0);
            int score = before == kNone ? kNone : before + own - (i > 0 ? kSkipped : 0);
            int at = beforeAt;
            if (i > 0 && j > 0 && best[i - 1][j - 1] != kNone &&
                best[i - 1][j - 1] + kFollows + own >= score) {
                score = best[i - 1][j - 1] + kFollows + own;
                at = static_cast<int>(j) - 1;
            }
            best[i][j] = score;
            from[i][j] = at;
        }
    }
    const auto last = std::max_element(best.back().begin(), best.back().end());
    if (last == best.back().end() || *last == kNone) {
        return std::nullopt;
    }
    FuzzyMatch match{*last, std::vector<int>(rows)};
    auto place = static_cast<int>(last - best.back().begin());
    for (std::size_t i = rows; i-- > 0;) {
        match.letters[i] = place;
        place = from[i][static_cast<std::size_t>(place)];
    }
    return isScattered(match.letters, given) ? std::nullopt : std::optional(match);
}

bool beginsWord(const QString& letters, const QString& text) {
    const QString wanted = folded(letters), given = folded(text);
    for (auto at = given.indexOf(wanted); at >= 0; at = given.indexOf(wanted, at + 1)) {
        if (at < given.size() && beginsWordAt(given, at)) {
            return true;
        }
    }
    return wanted.isEmpty();
}

std::vector<FoundCommand> searchCommands(const std::vector<Command>& commands,
                                         const QString& typed) {
    const QStringList words = typed.simplified().split(' ', Qt::SkipEmptyParts);
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        Candidate candidate{{static_cast<int>(i), {}}, commands[i].enabled};
        if ((!words.isEmpty() || commands[i].listedUnasked) &&
            score(commands[i], words, candidate)) {
            candidates.push_back(std::move(candidate));
        }
    }
    std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
        const auto order = [](const Candidate& of) {
            return std::tuple(!of.enabled, -static_cast<int>(of.fit), -of.score, of.length);
        };
        return order(a) < order(b);
    });
    std::vector<FoundCommand> found;
    found.reserve(candidates.size());
    for (Candidate& candidate : candidates) {
        found.push_back(std::move(candidate.found));
    }
    return found;
}

}  // namespace toile::app
