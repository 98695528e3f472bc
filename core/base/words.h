// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

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

}  // namespace toile
