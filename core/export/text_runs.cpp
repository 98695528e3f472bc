// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/text_runs.h"

#include <algorithm>

#include <hb.h>

#include "core/base/characters.h"

namespace toile {
namespace {

enum class Turn { Right, Left, Number, Neutral, AsBefore };

struct Character {
    char32_t code;
    Turn turn;
    std::uint32_t script;
    bool isAttached;  ///< to the preceding character
    bool isRightToLeft = false;
    int level = 0;  ///< of nested directions, even ones to the right
};

bool isScript(std::uint32_t script) {
    return script != HB_SCRIPT_COMMON && script != HB_SCRIPT_INHERITED &&
           script != HB_SCRIPT_UNKNOWN;
}

Turn turnOf(hb_unicode_general_category_t category, hb_script_t script) {
    switch (category) {
        case HB_UNICODE_GENERAL_CATEGORY_DECIMAL_NUMBER:
            return Turn::Number;
        case HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK:
        case HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK:
        case HB_UNICODE_GENERAL_CATEGORY_FORMAT:
            return Turn::AsBefore;
        case HB_UNICODE_GENERAL_CATEGORY_MODIFIER_LETTER:
        case HB_UNICODE_GENERAL_CATEGORY_OTHER_LETTER:
        case HB_UNICODE_GENERAL_CATEGORY_LOWERCASE_LETTER:
        case HB_UNICODE_GENERAL_CATEGORY_UPPERCASE_LETTER:
            break;
        default:
            if (!isScript(script)) {
                return Turn::Neutral;
            }
    }
    return hb_script_get_horizontal_direction(script) == HB_DIRECTION_RTL ? Turn::Left
                                                                          : Turn::Right;
}

std::vector<Character> charactersOf(std::string_view line) {
    hb_unicode_funcs_t* const unicode = hb_unicode_funcs_get_default();
    std::vector<Character> all;
    for (const char32_t code : codePoints(cleanText(line))) {
        const hb_script_t script = hb_unicode_script(unicode, code);
        const Turn turn = turnOf(hb_unicode_general_category(unicode, code), script);
        all.push_back({code, turn, script, turn == Turn::AsBefore});
    }
    return all;
}

/// Characters without a script get that of the preceding character, else of the first with one.
void settleScripts(std::vector<Character>& line) {
    const auto first =
        std::ranges::find_if(line, [](const Character& c) { return isScript(c.script); });
    std::uint32_t script = HB_SCRIPT_COMMON;
    script = first == line.end() ? script : first->script;
    for (Character& character : line) {
        script = isScript(character.script) ? character.script : script;
        character.script = script;
    }
}

bool joinsNumbers(char32_t code) {
    return code == '.' || code == ',' || code == ':' || code == '/' || code == '-' || code == '+';
}

/// Accents follow their letters, points within numbers these numbers, and numbers after letters
/// that run to the right are treated like these letters.
void settleNumbers(std::vector<Character>& line, Turn base) {
    Turn letters = base;
    for (std::size_t k = 0; k < line.size(); ++k) {
        Turn& turn = line[k].turn;
        if (turn == Turn::AsBefore) {
            turn = k > 0 ? line[k - 1].turn : Turn::Neutral;
        } else if (turn == Turn::Neutral && k > 0 && k + 1 < line.size() &&
                   joinsNumbers(line[k].code) && line[k - 1].turn == Turn::Number &&
                   line[k + 1].turn == Turn::Number) {
            turn = Turn::Number;
        } else if (turn == Turn::Number && letters == Turn::Right) {
            turn = Turn::Right;
        } else if (turn == Turn::Left || turn == Turn::Right) {
            letters = turn;
        }
    }
}

void settleNeutrals(std::vector<Character>& line, Turn base) {
    const auto asLetters = [](Turn turn) { return turn == Turn::Number ? Turn::Left : turn; };
    for (std::size_t k = 0; k < line.size();) {
        std::size_t end = k;
        while (end < line.size() && line[end].turn == Turn::Neutral) {
            ++end;
        }
        const Turn before = k > 0 ? asLetters(line[k - 1].turn) : base;
        const Turn after = end < line.size() ? asLetters(line[end].turn) : base;
        for (; k < end; ++k) {
            line[k].turn = before == after ? before : base;
        }
        ++k;
    }
}

void settleDirections(std::vector<Character>& line) {
    const auto first = std::ranges::find_if(line, [](const Character& c) -> bool {
        return c.turn == Turn::Left || c.turn == Turn::Right;
    });
    const Turn base = first == line.end() ? Turn::Right : first->turn;
    settleNumbers(line, base);
    settleNeutrals(line, base);
    for (Character& character : line) {
        character.isRightToLeft = character.turn == Turn::Left;
        character.level = character.isRightToLeft                                ? 1
                          : base == Turn::Left || character.turn == Turn::Number ? 2
                                                                                 : 0;
    }
}

struct LevelRun : TextRun {
    int level = 0;
};

/// Converts reading order to visual order: the deepest nesting is reversed first.
void reorder(std::vector<LevelRun>& runs) {
    for (const int level : {2, 1}) {
        for (auto from = runs.begin(); from != runs.end();) {
            const auto isInside = [level](const LevelRun& run) { return run.level >= level; };
            from = std::find_if(from, runs.end(), isInside);
            const auto to = std::find_if_not(from, runs.end(), isInside);
            std::reverse(from, to);
            from = to;
        }
    }
}

}  // namespace

std::vector<TextRun> textRuns(std::string_view line,
                              const std::function<std::size_t(char32_t)>& fontOf) {
    std::vector<Character> characters = charactersOf(line);
    settleScripts(characters);
    settleDirections(characters);
    std::vector<LevelRun> runs;
    for (const Character& character : characters) {
        const std::size_t font =
            character.isAttached && !runs.empty() ? runs.back().font : fontOf(character.code);
        if (runs.empty() || runs.back().font != font || runs.back().script != character.script ||
            runs.back().level != character.level) {
            runs.push_back(
                {{{}, font, character.script, character.isRightToLeft}, character.level});
        }
        runs.back().characters += character.code;
    }
    reorder(runs);
    return {runs.begin(), runs.end()};
}

}  // namespace toile
