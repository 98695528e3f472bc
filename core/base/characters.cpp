// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/characters.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/wording.h"

namespace toile {
namespace {

constexpr char32_t kUnknown = 0xFFFD;

/// Removes and returns the first character of `text`; kUnknown, one byte, if it is not UTF-8.
char32_t takeCharacter(std::string_view& text) {
    const auto byte = [&text](std::size_t i) {
        return static_cast<char32_t>(static_cast<unsigned char>(text[i]));
    };
    const char32_t lead = byte(0);
    const std::size_t length = lead < 0x80           ? 1
                               : (lead >> 5) == 0x06 ? 2
                               : (lead >> 4) == 0x0E ? 3
                               : (lead >> 3) == 0x1E ? 4
                                                     : 0;
    char32_t value = length < 2 ? lead : lead & (0x7Fu >> length);
    bool good = length > 0 && length <= text.size();
    for (std::size_t i = 1; good && i < length; ++i) {
        good = (byte(i) >> 6) == 0x02;
        value = (value << 6) | (byte(i) & 0x3F);
    }
    constexpr std::array<char32_t, 5> kMin{0, 0, 0x80, 0x800, 0x10000};
    good = good && value >= kMin[length] && value <= 0x10FFFF && (value >> 11) != 0x1B &&
           (value & ~char32_t{1}) != 0xFFFE;
    text.remove_prefix(good ? length : 1);
    return good ? value : kUnknown;
}

bool isControl(char32_t c) {
    return c < 0x20 || (c >= 0x7F && c < 0xA0) || (c >= 0x2028 && c <= 0x202E) ||
           (c >= 0x2066 && c <= 0x2069);
}

/// Plain letters for U+00C0 to U+017F, one each; '*' where several or none are needed.
constexpr std::string_view kLatin =
    "AAAAAA*CEEEEIIIIDNOOOOOxOUUUUY**"
    "aaaaaa*ceeeeiiiidnooooo*ouuuuy*y"
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGg"
    "GgGgHhHhIiIiIiIiIi**JjKkkLlLlLlL"
    "lLlNnNnNnnNnOoOoOo**RrRrRrSsSsSs"
    "SsTtTtTtUuUuUuUuUuUuWwYyYZzZzZzs";
static_assert(kLatin.size() == 0x180 - 0xC0);

/// Replacements of other characters, and of those above that need several letters.
constexpr Word<char32_t> kOthers[] = {
    {0xC6, "AE"},  {0xDE, "Th"},  {0xDF, "ss"},   {0xE6, "ae"},  {0xFE, "th"},
    {0x132, "IJ"}, {0x133, "ij"}, {0x152, "OE"},  {0x153, "oe"}, {0x2013, "-"},  // dashes
    {0x2014, "-"}, {0x2019, "'"}, {0x1E9E, "SS"}, {0xA0, " "},  // blank that does not break
};

/// Latin letters for Greek from U+03B1 and Cyrillic from U+0430 on, small letters, as in passports
/// (ICAO 9303); empty for a letter without a sound of its own.
constexpr std::string_view kGreek[] = {"a", "v", "g", "d", "e",  "z",  "i", "th", "i",
                                       "k", "l", "m", "n", "x",  "o",  "p", "r",  "s",
                                       "s", "t", "y", "f", "ch", "ps", "o"};
constexpr std::string_view kCyrillic[] = {
    "a", "b", "v", "g", "d", "e",  "zh", "z",  "i",  "i",    "k",  "l", "m", "n", "o",  "p",
    "r", "s", "t", "u", "f", "kh", "ts", "ch", "sh", "shch", "ie", "y", "",  "e", "iu", "ia"};
constexpr Word<char32_t> kMoreLetters[] = {
    {0x3AC, "a"}, {0x3AD, "e"}, {0x3AE, "i"},  {0x3AF, "i"},  {0x3CA, "i"},  {0x3CB, "y"},
    {0x3CC, "o"}, {0x3CD, "y"}, {0x3CE, "o"},  {0x390, "i"},  {0x3B0, "y"},  {0x450, "e"},
    {0x451, "e"}, {0x452, "d"}, {0x453, "g"},  {0x454, "ie"}, {0x455, "dz"}, {0x456, "i"},
    {0x457, "i"}, {0x458, "j"}, {0x459, "lj"}, {0x45A, "nj"}, {0x45B, "c"},  {0x45C, "k"},
    {0x45D, "i"}, {0x45E, "u"}, {0x45F, "dz"}, {0x491, "g"},  {0x386, "A"},  {0x388, "E"},
    {0x389, "I"}, {0x38A, "I"}, {0x38C, "O"},  {0x38E, "Y"},  {0x38F, "O"},  {0x490, "G"}};

/// The Latin letters of a Greek or Cyrillic one; nothing for other characters.
std::optional<std::string> latinLetters(char32_t c) {
    const bool isCapital = (c >= 0x391 && c <= 0x3AB) || (c >= 0x400 && c < 0x430);
    const char32_t small = isCapital ? c + (c >= 0x400 && c < 0x410 ? 0x50 : 0x20) : c;
    const auto more = std::ranges::find(kMoreLetters, small, &Word<char32_t>::first);
    std::string letters;
    if (more != std::end(kMoreLetters)) {
        letters = more->second;
    } else if (small >= 0x3B1 && small <= 0x3C9) {
        letters = kGreek[small - 0x3B1];
    } else if (small >= 0x430 && small <= 0x44F) {
        letters = kCyrillic[small - 0x430];
    } else {
        return {};
    }
    if (small != c && !letters.empty()) {
        letters.front() = static_cast<char>(letters.front() - 'a' + 'A');
    }
    return letters;
}

std::string_view severalLetters(char32_t c) {
    const auto known = std::ranges::find(kOthers, c, &Word<char32_t>::first);
    return known == std::end(kOthers) ? "_" : known->second;
}

bool isCombiningMark(char32_t c) {
    return c >= 0x300 && c < 0x370;
}

}  // namespace

std::size_t characterCount(std::string_view text) {
    std::size_t count = 0;
    for (; !text.empty(); ++count) {
        takeCharacter(text);
    }
    return count;
}

std::u32string codePoints(std::string_view text) {
    std::u32string all;
    while (!text.empty()) {
        all += takeCharacter(text);
    }
    return all;
}

std::string cleanText(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const std::string_view rest = text;
        const char32_t c = takeCharacter(text);
        if (isControl(c)) {
            out += ' ';
        } else if (c == kUnknown) {
            out += "\xEF\xBF\xBD";
        } else {
            out.append(rest.substr(0, rest.size() - text.size()));
        }
    }
    return out;
}

std::string readableName(std::string_view bytes) {
    for (std::string_view rest = bytes; !rest.empty();) {
        const std::size_t before = rest.size();
        if (takeCharacter(rest) == kUnknown && before - rest.size() == 1) {
            std::string latin1;
            for (const char c : bytes) {
                const auto byte = static_cast<unsigned char>(c);
                if (byte >= 0x80) {
                    latin1 += static_cast<char>(0xC0 | (byte >> 6));
                }
                latin1 += static_cast<char>(byte < 0x80 ? byte : 0x80 | (byte & 0x3F));
            }
            return cleanText(latin1);
        }
    }
    return cleanText(bytes);
}

std::string shownText(std::string_view bytes, std::size_t most) {
    std::string name = readableName(bytes);
    std::string_view rest = name;
    for (std::size_t count = 0; !rest.empty(); ++count) {
        if (count == most) {
            return name.substr(0, name.size() - rest.size()) + "…";
        }
        takeCharacter(rest);
    }
    return name;
}

std::string asciiText(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const char32_t c = takeCharacter(text);
        if (c >= 0x20 && c < 0x7F) {
            out += static_cast<char>(c);
        } else if (c >= 0xC0 && c < 0x180 && kLatin[c - 0xC0] != '*') {
            out += kLatin[c - 0xC0];
        } else if (const auto letters = latinLetters(c)) {
            out += *letters;
        } else if (!isCombiningMark(c)) {
            out += severalLetters(c);
        }
    }
    return out;
}

}  // namespace toile
