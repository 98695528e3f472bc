// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/first_word.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <system_error>

#include "app/cli/input.h"
#include "core/base/characters.h"
#include "core/base/text.h"

namespace toile::app {
namespace {

/// How many letters are to be added, left out or exchanged for others to make one word the other.
std::size_t lettersApart(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t k = 0; k < b.size(); ++k) {
            const std::size_t kept = diagonal + (lowered(a[i]) == b[k] ? 0 : 1);
            diagonal = row[k + 1];
            row[k + 1] = std::min({kept, diagonal + 1, row[k] + 1});
        }
    }
    return row.back();
}

/// The command that is a slip or two away; empty where none is. More would be another word.
std::string commandMeant(const std::string& word, const std::vector<std::string>& commands) {
    constexpr std::size_t kLettersOfASlip = 3;
    std::string meant;
    std::size_t least = word.size() / kLettersOfASlip + 1;
    for (const std::string& command : commands) {
        if (const std::size_t apart = lettersApart(word, command); apart < least) {
            least = apart;
            meant = command;
        }
    }
    return meant;
}

}  // namespace

std::vector<std::string> wordsAfterProgram(int argc, const char* const* argv) {
    std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    if (!words.empty() && words.front() == "help") {
        words.erase(words.begin());
        words.resize(std::min<std::size_t>(words.size(), 1));
        std::erase_if(
            words, [](const std::string& word) { return word == "help" || word.starts_with('-'); });
        words.emplace_back("--help");
    }
    return words;
}

std::string unknownFirstWord(const std::vector<std::string>& words,
                             const std::vector<std::string>& commands) {
    const std::string word = words.empty() ? "" : words.front();
    std::error_code ignored;
    if (word.empty() || word.starts_with('-') || looksLikeGarment(word) ||
        std::ranges::find(commands, word) != commands.end() ||
        std::filesystem::exists(word, ignored)) {
        return {};
    }
    std::vector<std::string> known = commands;
    known.emplace_back("help");
    const std::string meant = commandMeant(word, known);
    return "there is no command or file \"" + shownText(word, kMaxOfPlace) + '"' +
           (meant.empty() ? "" : " (did you mean " + meant + "?)");
}

}  // namespace toile::app
