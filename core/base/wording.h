// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace toile {

/// What a person is told of particulars: the English text, and the pattern and arguments it is made
/// of, so that the window can say the same in another language.
class Wording : public std::string {
public:
    Wording() = default;
    /// The same in every language: a name, a figure, what a file says.
    Wording(std::string text) : std::string(std::move(text)) {}
    Wording(const char* text) : std::string(text) {}
    /// Use `worded` and `figure`.
    Wording(const char* pattern, std::vector<Wording> arguments);
    Wording(double value, int decimals);

    /// Null where the text is the same in every language.
    const char* pattern() const { return pattern_; }
    /// What stands at %1, %2 ... of the pattern.
    const std::vector<Wording>& arguments() const { return arguments_; }
    /// Of a figure; else negative.
    int decimals() const { return decimals_; }
    double value() const { return value_; }

    /// One text after the other.
    Wording& operator+=(const Wording& more);

private:
    const char* pattern_ = nullptr;
    std::vector<Wording> arguments_;
    double value_ = 0;
    int decimals_ = -1;
};

/// @param pattern  a literal, where the translations are collected from; %1 to %9 stand for the
/// arguments
Wording worded(const char* pattern, std::vector<Wording> arguments = {});
/// A literal that is given on as a pattern, marked for those who collect the translations.
constexpr const char* translatable(const char* text) {
    return text;
}
/// "1 face", "2 faces" (`counted` of text.h).
Wording countWording(long long count, std::string_view noun);
/// A number with so many decimals, never "-0.0"; one that is too large for anything as "5.77e+300".
Wording figure(double value, int decimals = 0);
/// "(1.0, 2.0, 3.0)", as the places of messages are written.
Wording placeWording(double x, double y, double z);

}  // namespace toile
