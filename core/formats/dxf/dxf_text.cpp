// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/dxf/dxf_text.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include <iconv.h>

#include "core/base/text.h"

namespace toile {
namespace {

constexpr std::string_view kUnknownCharacter = "\xEF\xBF\xBD";
constexpr const char* kWesternPage = "CP1252";
constexpr std::size_t kMaxPageName = 20;
constexpr std::string_view kFirstUtf8Version = "AC1021";
constexpr unsigned char kThreeBytes = 0xE0;  // of UTF-8: first byte of sequences of three or more
/// Code pages of two bytes a character.
constexpr std::string_view kWidePages[] = {"CP932", "CP936", "CP949", "CP950",
                                           "GBK",   "JOHAB", "big5"};

struct Converted {
    std::string text{};
    long long lost = 0;  ///< bytes outside the code page
};

/// Converts bytes from a code page, by its iconv name, to UTF-8; nothing if iconv lacks the page.
std::optional<Converted> toUtf8(std::string_view bytes, const std::string& page) {
    const iconv_t converter = iconv_open("UTF-8", page.c_str());
    if (converter == reinterpret_cast<iconv_t>(-1)) {  // NOLINT: iconv's error value
        return {};
    }
    Converted made;
    made.text.reserve(bytes.size() + bytes.size() / 2);
    std::string in(bytes);  // iconv's signature requires a non-const input
    char* from = in.data();
    std::size_t left = in.size();
    char piece[4096];
    while (left > 0) {
        char* to = piece;
        std::size_t room = sizeof piece;
        const std::size_t before = left;
        iconv(converter, &from, &left, &to, &room);
        made.text.append(piece, to);
        if (left == before) {  // an invalid byte, or an incomplete character at the end
            made.text += kUnknownCharacter;
            ++made.lost;
            ++from;
            --left;
        }
    }
    iconv_close(converter);
    return made;
}

/// The value that follows the name of a header variable and a group code.
std::string_view headerValue(std::string_view bytes, std::string_view variable) {
    const std::size_t at = bytes.find(variable);
    std::string_view rest = bytes.substr(std::min(at, bytes.size()));
    for (int line = 0; line < 2; ++line) {
        rest.remove_prefix(std::min(rest.find('\n'), rest.size() - !rest.empty()) + !rest.empty());
    }
    return trimmed(rest.substr(0, rest.find('\n')));
}

/// iconv's name of a code page: CP936 for "ANSI_936", CP850 for "dos850", ISO-8859-2 for "8859_2".
std::string iconvPage(std::string_view page) {
    std::string name(page);
    std::ranges::transform(name, name.begin(), lowered);
    const bool isName =
        name.size() <= kMaxPageName && std::ranges::all_of(name, [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
        });
    if (!isName) {
        return {};
    }
    static constexpr std::pair<std::string_view, const char*> kPrefixes[] = {
        {"ansi_1361", "JOHAB"},    {"ansi_", "CP"},           {"dos", "CP"},
        {"iso8859-", "ISO-8859-"}, {"8859_", "ISO-8859-"},    {"ksc5601", "CP949"},
        {"gb2312", "GBK"},         {"mac-roman", "MACINTOSH"}};
    for (const auto& [prefix, own] : kPrefixes) {
        if (name.starts_with(prefix)) {
            return own + name.substr(prefix.size());
        }
    }
    return name;
}

/// Whether the text has letters of U+0180 to U+02FF except Romanian ones. Names hardly ever have
/// them, but bytes of Chinese names in a code page may look like them.
bool hasRareLetters(std::string_view bytes) {
    for (std::size_t k = 0; k + 1 < bytes.size(); ++k) {
        const auto lead = static_cast<unsigned char>(bytes[k]),
                   next = static_cast<unsigned char>(bytes[k + 1]);
        const bool isRomanian = lead == 0xC8 && next >= 0x98 && next <= 0x9B;
        if (lead >= 0xC6 && lead <= 0xCB && !isRomanian) {
            return true;
        }
    }
    return false;
}

void appendCharacter(std::string& out, char32_t c) {
    const auto add = [&out](char32_t byte) { out += static_cast<char>(byte); };
    if (c == 0 || c > 0x10FFFF || (c >> 11) == 0x1B) {
        out += kUnknownCharacter;
    } else if (c < 0x80) {
        add(c);
    } else if (c < 0x800) {
        add(0xC0 | (c >> 6));
        add(0x80 | (c & 0x3F));
    } else {
        add(c < 0x10000 ? 0xE0 | (c >> 12) : 0xF0 | (c >> 18));
        if (c >= 0x10000) {
            add(0x80 | ((c >> 12) & 0x3F));
        }
        add(0x80 | ((c >> 6) & 0x3F));
        add(0x80 | (c & 0x3F));
    }
}

/// Reads a number of `count` digits at the start of `text`.
std::optional<char32_t> digitsAt(std::string_view text, std::size_t count, int base) {
    unsigned value = 0;
    const char* const end = text.data() + std::min(count, text.size());
    const auto [after, error] = std::from_chars(text.data(), end, value, base);
    const bool isWhole = text.size() >= count && error == std::errc() && after == end;
    return isWhole ? std::optional<char32_t>(value) : std::nullopt;
}

/// Reads a \U+ or \M+ escape at the start of `rest`, appends its character and removes it from
/// `rest`. Returns false if there is none.
bool takeEscape(std::string_view& rest, std::string& out) {
    constexpr std::size_t kUnicodeLength = 7, kPageLength = 8;
    if (rest.starts_with("\\U+")) {
        auto code = digitsAt(rest.substr(3), 4, 16);
        if (!code) {
            return false;
        }
        rest.remove_prefix(kUnicodeLength);
        if ((*code >> 10) == 0x36 && rest.starts_with("\\U+")) {  // a high surrogate
            const auto low = digitsAt(rest.substr(3), 4, 16);
            if (low && (*low >> 10) == 0x37) {
                code = 0x10000 + ((*code & 0x3FF) << 10) + (*low & 0x3FF);
                rest.remove_prefix(kUnicodeLength);
            }
        }
        appendCharacter(out, *code);
        return true;
    }
    static constexpr const char* kPages[] = {"CP932", "CP950", "CP949", "JOHAB", "CP936"};
    const auto page = rest.starts_with("\\M+") ? digitsAt(rest.substr(3), 1, 10) : std::nullopt;
    const auto code = page ? digitsAt(rest.substr(4), 4, 16) : std::nullopt;
    if (!code || *page < 1 || *page > std::size(kPages)) {
        return false;
    }
    const char bytes[] = {static_cast<char>(*code >> 8), static_cast<char>(*code & 0xFF)};
    const auto made = toUtf8({bytes, sizeof bytes}, kPages[*page - 1]);
    out += made && made->lost == 0 ? made->text : std::string(kUnknownCharacter);
    rest.remove_prefix(kPageLength);
    return true;
}

/// Does the same for %% codes.
bool takeSign(std::string_view& rest, std::string& out) {
    if (!rest.starts_with("%%") || rest.size() < 3) {
        return false;
    }
    if (const auto code = digitsAt(rest.substr(2), 3, 10); code && *code < 0x100) {
        appendCharacter(out, *code);
        rest.remove_prefix(5);
        return true;
    }
    static constexpr std::pair<char, const char*> kSigns[] = {
        {'c', "⌀"}, {'d', "°"}, {'p', "±"}, {'%', "%"}, {'u', ""}, {'o', ""}, {'k', ""}};
    const auto sign =
        std::ranges::find(kSigns, lowered(rest[2]), &std::pair<char, const char*>::first);
    if (sign == std::end(kSigns)) {
        return false;
    }
    out += sign->second;
    rest.remove_prefix(3);
    return true;
}

}  // namespace

std::optional<std::string> decodedDxf(std::string_view bytes, std::vector<Wording>& notes) {
    const auto isAscii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
    if (std::ranges::all_of(bytes, isAscii)) {
        return {};
    }
    const std::string stated(headerValue(bytes, "$DWGCODEPAGE"));
    const std::string page = iconvPage(stated);
    const auto utf8 = toUtf8(bytes, "UTF-8");
    if (utf8 && utf8->lost == 0) {
        // East Asian characters take three bytes in UTF-8, so two-byte ones may be of a code page.
        const bool mayBeOther = headerValue(bytes, "$ACADVER") < kFirstUtf8Version &&
                                std::ranges::none_of(bytes, [](char c) {
                                    return static_cast<unsigned char>(c) >= kThreeBytes;
                                });
        const bool isWide = std::ranges::find(kWidePages, page) != std::end(kWidePages);
        auto wide = mayBeOther && isWide ? toUtf8(bytes, page) : std::nullopt;
        if (wide && wide->lost == 0) {
            return std::move(wide->text);
        }
        if (mayBeOther && stated.empty() && hasRareLetters(bytes)) {
            notes.push_back(
                worded("it states no code page, so it is read as UTF-8; if names are wrong, save "
                       "it with $DWGCODEPAGE"));
        }
        return {};
    }
    auto made = page.empty() ? std::nullopt : toUtf8(bytes, page);
    if (made && made->lost > 0) {
        notes.push_back(
            worded("some characters are not in its code page %1; they are shown as \xEF\xBF\xBD",
                   {stated}));
    }
    if (!made) {
        notes.push_back(
            stated.empty()
                ? worded("it states no code page, so its names are read as Western European and "
                         "may be wrong; save it with $DWGCODEPAGE or as UTF-8")
                : worded("its code page %1 is unknown, so its names are read as Western European "
                         "and may be wrong; save it as UTF-8",
                         {Wording(stated.substr(0, kMaxPageName))}));
        made = toUtf8(bytes, kWesternPage);
    }
    return made ? std::optional(std::move(made->text)) : std::nullopt;
}

bool hasDxfEscapes(std::string_view value) {
    return value.find("%%") != std::string_view::npos ||
           value.find("\\U+") != std::string_view::npos ||
           value.find("\\M+") != std::string_view::npos;
}

std::string withoutDxfEscapes(std::string_view rest) {
    std::string out;
    while (!rest.empty()) {
        if (!takeEscape(rest, out) && !takeSign(rest, out)) {
            out += rest.front();
            rest.remove_prefix(1);
        }
    }
    return out;
}

std::string plainMText(std::string_view value) {
    constexpr std::string_view kWithValue = "fFHhWwQqTtAaCcpS";  // value ends at a semicolon
    constexpr std::string_view kBlanks = "Pp~XN", kLiteral = "\\{}";
    std::string out;
    for (std::size_t k = 0; k < value.size(); ++k) {
        if (value[k] == '{' || value[k] == '}') {
            continue;
        }
        if (value[k] != '\\' || k + 1 == value.size()) {
            out += value[k];
            continue;
        }
        const char code = value[++k];
        if (const std::size_t end = value.find(';', k);
            kWithValue.find(code) != std::string_view::npos && end != std::string_view::npos) {
            k = end;
        } else if (kLiteral.find(code) != std::string_view::npos) {
            out += code;
        } else if (kBlanks.find(code) != std::string_view::npos) {
            out += ' ';
        }
    }
    return out;
}

}  // namespace toile
