// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/characters.h"

#include <array>

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
        } else if (!isCombiningMark(c)) {
            out += severalLetters(c);
        }
    }
    return out;
}

}  // namespace toile
