// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/option_archive.h"

#include <algorithm>

#include "core/base/text.h"

namespace toile::app {
std::string Option::key() const {
    const std::size_t begin = names.find("--");
    return begin == std::string::npos ? names : names.substr(begin, names.find(',', begin) - begin);
}

std::string outOfRange(const std::string& typed, const Range& range, bool isWhole) {
    return std::string(isWhole ? "needs a whole number from " : "needs a number from ") +
           textOf(range) + ", not \"" + typed + '"';
}

std::string textOf(const Range& range) {
    return numberText(range.least) + " to " + numberText(range.most);
}

std::string numberText(double number) {
    constexpr double kMaxExact = 9e15;
    return number == std::floor(number) && std::abs(number) < kMaxExact
               ? std::to_string(static_cast<long long>(number))
               : shortest(number);
}

std::string notAmong(const std::string& typed, const Words& words) {
    return typed + " not in {" + joined(words, ',') + '}';
}

std::string joined(const Words& words, char separator) {
    std::string text;
    for (const std::string& word : words) {
        text += text.empty() ? word : separator + word;
    }
    return text;
}

Words partsOf(std::string_view text, char separator) {
    Words parts;
    for (std::size_t end = 0; end != std::string_view::npos;) {
        end = text.find(separator);
        parts.emplace_back(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return parts;
}

void OptionArchive::section(const char* heading, OptionGroup group) {
    heading_ = heading;
    group_ = group;
}

Option& OptionArchive::add(const char* names, std::string value, std::string help,
                           std::function<std::string(const Words&)> read) {
    Option& row = rows_.emplace_back();
    row.names = names;
    row.value = std::move(value);
    row.help = std::move(help);
    row.heading = heading_;
    row.group = group_;
    row.read = std::move(read);
    return row;
}

std::string OptionArchive::read(const TypedWords& typed) const {
    for (const Option& row : rows_) {
        const auto words = typed.find(row.key());
        if (words == typed.end()) {
            continue;
        }
        if (const std::string wrong = row.read(words->second); !wrong.empty()) {
            return row.key() + ": " + wrong;
        }
    }
    return {};
}

Words OptionArchive::wordsOf(const TypedWords& typed, unsigned groups) const {
    Words words;
    for (const Option& row : rows_) {
        const auto found = typed.find(row.key());
        if (found == typed.end() || (row.group & groups) == 0) {
            continue;
        }
        words.push_back(found->first);
        words.insert(words.end(), found->second.begin(), found->second.end());
    }
    return words;
}

const Option* OptionArchive::find(std::string_view key) const {
    const auto row = std::ranges::find(rows_, key, &Option::key);
    return row == rows_.end() ? nullptr : &*row;
}

}  // namespace toile::app
