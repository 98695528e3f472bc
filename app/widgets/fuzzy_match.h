// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

namespace toile {

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

}  // namespace toile
