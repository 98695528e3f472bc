// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/text_cursor.h"

#include <limits>
#include <utility>

namespace toile::io {
namespace {

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// The value of a number beyond a double's range: its exponent's sign, or a leading zero if it has
/// no exponent, distinguishes tiny from huge.
double saturated(std::string_view number) {
    const bool negative = number.front() == '-';
    const std::size_t e = number.find_first_of("eE");
    const bool tiny = e != std::string_view::npos ? number.substr(e + 1).starts_with('-')
                                                  : number.substr(negative).starts_with('0');
    const double size = tiny ? 0.0 : std::numeric_limits<double>::infinity();
    return negative ? -size : size;
}

}  // namespace

TextCursor::TextCursor(std::string_view text)
    : begin_(text.data()), p_(text.data()), end_(text.data() + text.size()) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark)) {
        p_ += kByteOrderMark.size();
    }
}

bool TextCursor::skipJoinedLineEnd() {
    if (p_ + 1 == end_ || !isNewline(p_[1])) {
        return false;
    }
    ++p_;
    skipLineEnd();
    // The caller reads the next character, so one must be left.
    return p_ != end_;
}

void TextCursor::skipSpaceAndComments() {
    for (skipSpace(); at('#'); skipSpace()) {
        nextLine();
    }
}

void TextCursor::nextLine() {
    while (p_ != end_ && !isNewline(*p_)) {
        ++p_;
    }
    if (p_ != end_) {
        skipLineEnd();
    }
}

std::string_view TextCursor::token() {
    const char* first = p_;
    while (p_ != end_ && !isBlank(*p_) && !isNewline(*p_)) {
        ++p_;
    }
    return {first, static_cast<std::size_t>(p_ - first)};
}

std::string_view TextCursor::restOfLine() const {
    const char* first = p_;
    while (first != end_ && isBlank(*first)) {
        ++first;
    }
    const char* last = first;
    while (last != end_ && !isNewline(*last)) {
        ++last;
    }
    while (last != first && isBlank(last[-1])) {
        --last;
    }
    return {first, static_cast<std::size_t>(last - first)};
}

bool TextCursor::readDouble(double& value) {
    const char* first = p_;
    if (first != end_ && *first == '+') {
        ++first;
        if (first != end_ && *first == '-') {
            return false;
        }
    }
    const auto [last, status] = std::from_chars(first, end_, value);
    if (status == std::errc::invalid_argument) {
        return false;
    }
    if (status == std::errc::result_out_of_range) {
        value = saturated({first, static_cast<std::size_t>(last - first)});
    }
    const char* start = std::exchange(p_, last);
    if (!atTokenEnd()) {
        p_ = start;
        return false;
    }
    return true;
}

bool TextCursor::readDoubles(double* values, int count) {
    for (int i = 0; i < count; ++i) {
        skipBlanks();
        if (!readDouble(values[i])) {
            return false;
        }
    }
    return true;
}

bool hasDecimalComma(std::string_view text) {
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        if (text[i] == ',' && isDigit(text[i - 1]) && isDigit(text[i + 1])) {
            return true;
        }
    }
    return false;
}

}  // namespace toile::io
