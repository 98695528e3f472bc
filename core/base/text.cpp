// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"

#include <algorithm>
#include <charconv>

#include "core/base/characters.h"

namespace toile {
namespace {

// 17 significant digits, sign, point and exponent need 24; fixed notation of 1e308 needs 310 more.
constexpr int kMaxDigits = 400;

bool isZero(std::string_view digits) {
    return digits.find_first_not_of("-0.") == std::string_view::npos;
}

}  // namespace

void appendShortest(std::string& out, double value) {
    char buffer[kMaxDigits];
    const auto end = std::to_chars(buffer, buffer + kMaxDigits, value);
    out.append(buffer, end.ptr);
}

std::string shortest(double value) {
    std::string out;
    appendShortest(out, value);
    return out;
}

void appendFixed(std::string& out, double value, int decimals) {
    char buffer[kMaxDigits];
    const auto end =
        std::to_chars(buffer, buffer + kMaxDigits, value, std::chars_format::fixed, decimals);
    std::string_view digits(buffer, static_cast<std::size_t>(end.ptr - buffer));
    if (!digits.empty() && digits.front() == '-' && isZero(digits)) {
        digits.remove_prefix(1);  // a rounded -0.00001 should not look negative
    }
    out.append(digits);
}

std::string fixed(double value, int decimals) {
    std::string out;
    appendFixed(out, value, decimals);
    return out;
}

std::string scientific(double value, int decimals) {
    char buffer[kMaxDigits];
    const auto end =
        std::to_chars(buffer, buffer + kMaxDigits, value, std::chars_format::scientific, decimals);
    return {buffer, end.ptr};
}

std::string counted(long long count, std::string_view noun) {
    std::string out = std::to_string(count) + " " + std::string(noun);
    if (count == 1) {
        return out;
    }
    if (noun.ends_with("tex")) {  // vertex, vertices
        out.replace(out.size() - 2, 2, "ices");
        return out;
    }
    return out + "s";
}

std::string quotedList(const std::vector<std::string>& texts, std::size_t most) {
    std::string out;
    for (std::size_t i = 0; i < texts.size() && i < most; ++i) {
        out += (i == 0 ? "\"" : ", \"") + shownText(texts[i]) + '"';
    }
    return texts.size() > most ? out + " and " + std::to_string(texts.size() - most) + " more"
                               : out;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r\n\f";
    const std::size_t from = text.find_first_not_of(kBlanks);
    return from == std::string_view::npos
               ? std::string_view()
               : text.substr(from, text.find_last_not_of(kBlanks) - from + 1);
}

bool equalsIgnoringCase(std::string_view text, std::string_view word) {
    return std::ranges::equal(text, word, {}, lowered);
}

std::string slug(std::string_view text) {
    std::string out;
    for (const char typed : text) {
        const char c = lowered(typed);
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
            out += c;
        } else if (!out.empty() && out.back() != '-') {
            out += '-';
        }
    }
    while (!out.empty() && out.back() == '-') {
        out.pop_back();
    }
    return out.empty() ? "piece" : out;
}

}  // namespace toile
