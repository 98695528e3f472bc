// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/base/text.h"
#include "core/base/wording.h"

// For the sources of this folder that add options, which are compiled together: CLI11 takes
// seconds.
namespace toile::app {

template <class Value, std::size_t n>
std::vector<std::string> namesOf(const Word<Value> (&words)[n]) {
    std::vector<std::string> names;
    for (const auto& [value, word] : words) {
        names.emplace_back(word);
    }
    return names;
}

/// One of these words; the help lists them as the option's type already.
inline CLI::Validator oneOf(const std::vector<std::string>& words) {
    CLI::Validator member = CLI::IsMember(words);
    member.description("");
    return member;
}

template <class Number>
std::string limitText(Number limit) {
    if constexpr (std::is_integral_v<Number>) {
        return std::to_string(limit);
    } else {
        return shortest(double(limit));
    }
}

/// A number from one to the other, which "nan" is not: it is neither below nor above them.
template <class Number>
CLI::Validator within(Number least, Number most) {
    return {[least, most](const std::string& typed) {
                Number number{};
                if (CLI::detail::lexical_cast(typed, number) && number >= least && number <= most) {
                    return std::string();
                }
                return std::string(std::is_integral_v<Number> ? "takes a whole number from "
                                                              : "takes a number from ") +
                       limitText(least) + " to " + limitText(most) + ", not \"" + typed + '"';
            },
            CLI::Range(least, most).get_description()};
}

/// An option that takes one of these words.
/// @param parse  gives the value for each of them
template <class Value, class Parse>
CLI::Option* addChoice(CLI::App& command, const std::string& option, Value& value,
                       const std::vector<std::string>& words, const Parse& parse,
                       const std::string& help) {
    return command
        .add_option_function<std::string>(
            option, [&value, parse](const std::string& word) { value = *parse(word); }, help)
        ->type_name(CLI::detail::join(words, "|"))
        ->check(oneOf(words));
}

template <class Value, class Choice, std::size_t n>
CLI::Option* addChoice(CLI::App& command, const std::string& option, Value& value,
                       const Word<Choice> (&words)[n], const std::string& help) {
    return addChoice(
        command, option, value, namesOf(words),
        [&words](const std::string& word) { return parseWord(words, word); }, help);
}

/// The name of a report.
inline CLI::Validator jsonName() {
    return {[](const std::string& name) {
                return name.ends_with(".json") || name.ends_with(".JSON")
                           ? std::string()
                           : "the report's name must end in .json, not \"" + name + "\"";
            },
            ""};
}

}  // namespace toile::app
