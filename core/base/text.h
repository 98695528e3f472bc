// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace toile {

/// Numbers and names as text, independent of the user's locale. All functions are pure.

/// Shortest digits that read back to the same double, for example "0.1".
std::string shortest(double value);
/// Appends `shortest(value)` to `out` without a temporary.
void appendShortest(std::string& out, double value);
/// Fixed decimals, rounded to nearest; never "-0.0000".
std::string fixed(double value, int decimals);
void appendFixed(std::string& out, double value, int decimals);
/// A digit, decimals and a power of ten: "5.77e+300".
std::string scientific(double value, int decimals);
/// "1 face", "2 faces": adds an s to the noun if the count requires it.
std::string counted(long long count, std::string_view noun);
/// The first `most` texts in quotes, and how many more there are: "\"a\", \"b\" and 3 more".
std::string quotedList(const std::vector<std::string>& texts, std::size_t most);
/// Removes blanks (space, tab, line ends, form feed) at both ends; refers to the same characters.
std::string_view trimmed(std::string_view text);
/// An ASCII letter in lower case; any other character unchanged.
constexpr char lowered(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
/// True if `text` equals `word`, ignoring the case of ASCII letters; `word` is in lower case.
bool equalsIgnoringCase(std::string_view text, std::string_view word);
/// Lower case ASCII letters, digits and single hyphens, for ids and file names; never empty.
std::string slug(std::string_view text);

/// Gives each thing a unique name: as wanted, or with a number. n log n, also if thousands want the
/// same name.
class UniqueNames {
public:
    /// Reserves a name.
    void take(const std::string& name) { taken_.insert(name); }

    bool isFree(const std::string& name) const { return !taken_.contains(name); }

    /// The name itself if it is free, else with a number from 2 on.
    /// @param before  separator in front of the number
    std::string free(const std::string& wanted, const char* before = " ") {
        return taken_.insert(wanted).second ? wanted : numbered(wanted, before, 2);
    }

    /// Always with a number: for names of which there will be more.
    std::string numbered(const std::string& wanted, const char* before = " ", int first = 1) {
        for (int& next = nextNumber_.try_emplace(wanted, first).first->second;;) {
            std::string name = wanted + before + std::to_string(next++);
            if (taken_.insert(name).second) {
                return name;
            }
        }
    }

private:
    std::set<std::string> taken_;
    std::map<std::string, int> nextNumber_;
};

}  // namespace toile
