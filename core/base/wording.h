// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace toile {

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
