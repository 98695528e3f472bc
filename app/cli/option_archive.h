// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/wording.h"

namespace toile::app {

/// Subject of an option: `toile serve`, `toile batch` and Python accept some of them.
enum OptionGroup : unsigned {
    kForTerminal = 0,   ///< printing, exit status, pictures
    kInputFiles = 1,    ///< files to read
    kReading = 2,       ///< reading, dividing and cutting
    kFlattening = 4,    ///< flattening and drawing of pieces
    kThreads = 8,       ///< number of threads
    kOutputFiles = 16,  ///< files to write
    kExporting = 32,    ///< file formats
    kSewing = 64,       ///< proof by sewing
    kEveryOption = ~0U,
};

using Words = std::vector<std::string>;
/// The typed options of a command: values by key, such as "--unit". A flag has none.
using TypedWords = std::map<std::string, Words, std::less<>>;

/// The value of a bare `--fair`.
inline constexpr const char* kFairAlone = "auto";

/// Inclusive limits of a number.
struct Range {
    double least = 0, most = 0;
};

/// An option or positional argument of a command.
struct Option {
    std::string names;              ///< "-o,--output"; for a positional "INPUT"
    std::string value;              ///< placeholder or choices of its value: "MM"; empty: a flag
    std::string help;               ///< sentences without the last full stop
    std::string otherwise{};        ///< default value, for the help
    std::optional<Range> range{};   ///< of a number
    const char* heading = nullptr;  ///< of its section in the help
    OptionGroup group = kForTerminal;
    bool isRequired = false;
    bool isRepeated = false;        ///< takes several values
    const char* oldName = nullptr;  ///< older name that still works, hidden in the help
    std::vector<const char*> excluded{}, needed{};  ///< keys of other options
    /// Stores the typed values. @return the fault without the option's name; empty: valid
    std::function<std::string(const Words&)> read{};

    /// The first long name: "--output".
    std::string key() const;
    bool isFlag() const { return value.empty(); }

    Option& by(std::string text) { return otherwise = std::move(text), *this; }
    Option& required() { return isRequired = true, *this; }
    Option& formerly(const char* name) { return oldName = name, *this; }
    Option& excludes(std::initializer_list<const char*> keys) { return excluded = keys, *this; }
    Option& needs(const char* key) { return needed = {key}, *this; }
};

/// "0 to 5"
std::string textOf(const Range& range);
/// "takes a number from 0 to 5, not \"x\""
std::string outOfRange(const std::string& typed, const Range& range, bool isWhole);
/// Without exponent: 1000000 instead of 1e6.
std::string numberText(double number);
/// "x not in {a,b,c}"
std::string notAmong(const std::string& typed, const Words& words);
std::string joined(const Words& words, char separator);
/// The parts of a text between separators; an empty text gives one empty part.
Words partsOf(std::string_view text, char separator);

/// Parses the whole text as a finite number; accepts a leading +.
template <class Number>
std::optional<Number> parseNumber(std::string_view text) {
    text.remove_prefix(text.starts_with('+') && !text.starts_with("+-") ? 1 : 0);
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [last, error] = std::from_chars(text.data(), end, number);
    if constexpr (std::is_floating_point_v<Number>) {
        if (!std::isfinite(number)) {
            return std::nullopt;
        }
    }
    return error == std::errc() && last == end ? std::optional(number) : std::nullopt;
}

/// Describes the options of a command once for the parser, the help, the manual page and programs
/// that pass options as words. Each row refers to the member it sets, which must outlive the
/// archive. Rows are read in the order in which they were added.
class OptionArchive {
public:
    /// Starts a section of the help for the following options.
    void section(const char* heading, OptionGroup group);

    /// @param read  see `Option::read`
    Option& add(const char* names, std::string value, std::string help,
                std::function<std::string(const Words&)> read);

    /// Sets `target` to `set` if the flag is typed.
    template <class Target, class Value>
    Option& flag(const char* names, Target& target, Value set, const char* help) {
        return add(names, "", help, [&target, set](const Words&) -> std::string {
            target = set;
            return {};
        });
    }
    Option& flag(const char* names, bool& target, const char* help) {
        return flag(names, target, true, help);
    }

    /// @param take  called with a number in the range
    template <class Number, class Take>
    Option& numberOf(const char* names, const char* unit, const Range& range, const char* help,
                     Take take) {
        Option& row = add(names, unit, help, [range, take](const Words& typed) -> std::string {
            const auto number = parseNumber<Number>(typed.front());
            if (!number || !(double(*number) >= range.least && double(*number) <= range.most)) {
                return outOfRange(typed.front(), range, std::is_integral_v<Number>);
            }
            take(*number);
            return {};
        });
        row.range = range;
        return row;
    }

    /// The help shows the current value of `target` as the default, unless that is optional.
    template <class Number>
    requires std::is_arithmetic_v<Number> Option& number(const char* names, const char* unit,
                                                         Number& target, const Range& range,
                                                         const char* help) {
        return numberOf<Number>(names, unit, range, help, [&target](Number n) { target = n; })
            .by(numberText(double(target)));
    }
    template <class Number>
    Option& number(const char* names, const char* unit, std::optional<Number>& target,
                   const Range& range, const char* help) {
        return numberOf<Number>(names, unit, range, help, [&target](Number n) { target = n; });
    }

    /// A text or path; a path must not be empty.
    template <class Text>
    Option& text(const char* names, const char* value, Text& target, const char* help) {
        return add(names, value, help, [&target](const Words& typed) -> std::string {
            target = typed.front();
            return wrongPath<Text>(typed);
        });
    }
    /// Texts or paths; the option may be repeated.
    template <class Text>
    Option& texts(const char* names, const char* value, std::vector<Text>& target,
                  const std::string& help) {
        Option& row = add(names, value, help, [&target](const Words& typed) -> std::string {
            target.assign(typed.begin(), typed.end());
            return wrongPath<Text>(typed);
        });
        row.isRepeated = true;
        return row;
    }

    /// One of these words. @param parse  converts each word to its value
    template <class Value, class Parse>
    Option& choice(const char* names, Value& target, const Words& words, const Parse& parse,
                   const char* help) {
        return add(names, joined(words, '|'), help, [&target, words, parse](const Words& typed) {
            if (std::ranges::find(words, typed.front()) == words.end()) {
                return notAmong(typed.front(), words);
            }
            target = *parse(typed.front());
            return std::string();
        });
    }
    /// The help shows the current value of `target` as the default, unless that is optional.
    template <class Value, class Choice, std::size_t n>
    Option& choice(const char* names, Value& target, const Word<Choice> (&words)[n],
                   const char* help) {
        Words list;
        std::string current;
        for (const auto& [value, word] : words) {
            list.emplace_back(word);
            if constexpr (std::is_same_v<Value, Choice>) {
                current = value == target ? std::string(word) : current;
            }
        }
        return choice(
                   names, target, list,
                   [&words](const std::string& word) { return parseWord(words, word); }, help)
            .by(current);
    }

    /// Stores all typed values. @return the fault; empty: all are valid
    std::string read(const TypedWords& typed) const;
    /// Words that reproduce the typed options of these groups, in the order of the help.
    Words wordsOf(const TypedWords& typed, unsigned groups) const;

    /// Null if there is no such key.
    const Option* find(std::string_view key) const;
    const std::deque<Option>& rows() const { return rows_; }

private:
    /// An empty path would mean the current folder, usually from a variable that is not set.
    template <class Text>
    static std::string wrongPath(const Words& typed) {
        const bool isEmpty = std::is_same_v<Text, std::filesystem::path> &&
                             std::ranges::find(typed, "") != typed.end();
        return isEmpty ? "needs a name, not an empty text" : "";
    }

    std::deque<Option> rows_;  ///< a deque, so that adding a row keeps references to others valid
    const char* heading_ = nullptr;
    OptionGroup group_ = kForTerminal;
};

}  // namespace toile::app
