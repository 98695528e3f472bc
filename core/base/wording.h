// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace toile {

/// A choice and its name in files and on the command line. A table, `Word<Value> kTable[]`, names
/// each value once.
template <class Value>
using Word = std::pair<Value, std::string_view>;

/// Precondition: the table contains the value.
template <class Value, std::size_t n>
std::string_view wordOf(const Word<Value> (&words)[n], Value value) {
    return std::ranges::find(words, value, &Word<Value>::first)->second;
}

/// "\"a\", \"b\" or \"c\"": all of them, for display.
template <class Value, std::size_t n>
std::string wordList(const Word<Value> (&words)[n]) {
    std::string list;
    for (std::size_t k = 0; k < n; ++k) {
        list += k == 0 ? "\"" : k + 1 < n ? "\", \"" : "\" or \"";
        list += words[k].second;
    }
    return list + '"';
}

template <class Value, std::size_t n>
std::optional<Value> parseWord(const Word<Value> (&words)[n], std::string_view text) {
    const auto known = std::ranges::find(words, text, &Word<Value>::second);
    return known == std::end(words) ? std::nullopt : std::optional(known->first);
}

/// A text for a person: the English text, and the pattern and arguments that it is made of, so that
/// the window can translate it.
class Wording : public std::string {
public:
    Wording() = default;
    /// The same in every language: a name, a number, text from a file.
    Wording(std::string text) : std::string(std::move(text)) {}
    Wording(const char* text) : std::string(text) {}
    /// Use `worded` and `figure`.
    Wording(const char* pattern, std::vector<Wording> arguments);
    Wording(double value, int decimals);

    /// Null if the text is the same in every language.
    const char* pattern() const { return pattern_; }
    /// The arguments for %1, %2 ... of the pattern.
    const std::vector<Wording>& arguments() const { return arguments_; }
    /// Of a number; else negative.
    int decimals() const { return decimals_; }
    double value() const { return value_; }

    /// Appends a text.
    Wording& operator+=(const Wording& more);

private:
    const char* pattern_ = nullptr;
    std::vector<Wording> arguments_;
    double value_ = 0;
    int decimals_ = -1;
};

/// @param pattern  a literal, from which translations are collected; %1 to %9 are replaced by the
///                 arguments
Wording worded(const char* pattern, std::vector<Wording> arguments = {});
/// A literal that is passed on as a pattern, marked for the collector of translations.
constexpr const char* translatable(const char* text) {
    return text;
}
/// "1 face", "2 faces" (`counted` of text.h).
Wording countWording(long long count, std::string_view noun);
/// A number with this many decimals, never "-0.0"; one too large to write out as "5.77e+300".
Wording figure(double value, int decimals = 0);
/// "(1.0, 2.0, 3.0)", the format of places in messages.
Wording placeWording(double x, double y, double z);

}  // namespace toile
