// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <string_view>
#include <system_error>

namespace toile::io {

inline bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

inline bool isNewline(char c) {
    return c == '\n' || c == '\r';
}

/// A position in a text file held in memory, for readers that make one pass. Lines end in LF, CRLF
/// or CR; a backslash before a line's end joins it with the next. Numbers never depend on the
/// locale. The text must outlive the cursor.
class TextCursor {
public:
    /// Starts at the first byte after a byte order mark, in line 1.
    explicit TextCursor(std::string_view text);

    bool atEnd() const { return p_ == end_; }

    bool atLineEnd() const { return p_ == end_ || isNewline(*p_); }

    bool at(char c) const { return p_ != end_ && *p_ == c; }

    int line() const { return line_; }

    /// Bytes from the start of the text, and from here to its end.
    std::size_t offset() const { return static_cast<std::size_t>(p_ - begin_); }

    std::size_t bytesLeft() const { return static_cast<std::size_t>(end_ - p_); }

    /// Skips blanks and joined line ends.
    void skipBlanks() {
        while (p_ != end_ && (isBlank(*p_) || (*p_ == '\\' && skipJoinedLineEnd()))) {
            if (isBlank(*p_)) {
                ++p_;
            }
        }
    }

    /// Skips blanks and line ends.
    void skipSpace() {
        for (skipBlanks(); p_ != end_ && isNewline(*p_); skipBlanks()) {
            skipLineEnd();
        }
    }

    /// Skips blanks, line ends and comments (from `#` to the line's end).
    void skipSpaceAndComments();
    /// Goes to the start of the next line.
    void nextLine();

    /// Skips one character, if it is there.
    bool skip(char c) { return at(c) && (++p_, true); }

    /// Reads up to the next blank or line end.
    std::string_view token();
    /// The text from here to the line's end, without blanks at either side; does not move.
    std::string_view restOfLine() const;

    /// Reads a number ("1.5", "+1e-3", "nan", "-inf") followed by a blank or the line's end. Too
    /// large ones are infinite, too small ones zero. Does not move if there is no number.
    bool readDouble(double& value);
    /// Reads `count` numbers of this line, each after blanks; false at the first that is not a
    /// number.
    bool readDoubles(double* values, int count);

    enum class IntStatus { Ok, TooLarge, NotANumber };
    /// Reads a whole number, also past one that is too large; stops at the next character. Inline,
    /// as a file has millions of them: a tenth of the time to read an OBJ file.
    IntStatus readInt(int& value) {
        const char* first = p_;
        if (first != end_ && *first == '+') {
            ++first;
            if (first != end_ && *first == '-') {
                return IntStatus::NotANumber;
            }
        }
        const auto [last, status] = std::from_chars(first, end_, value);
        if (status == std::errc::invalid_argument) {
            return IntStatus::NotANumber;
        }
        p_ = last;
        return status == std::errc() ? IntStatus::Ok : IntStatus::TooLarge;
    }

    /// True at a blank, a line's end, the text's end or a backslash.
    bool atTokenEnd() const { return p_ == end_ || isBlank(*p_) || isNewline(*p_) || *p_ == '\\'; }

private:
    bool skipJoinedLineEnd();

    void skipLineEnd() {
        p_ += (*p_ == '\r' && p_ + 1 != end_ && p_[1] == '\n') ? 2 : 1;
        ++line_;
    }

    const char* begin_;
    const char* p_;
    const char* end_;
    int line_ = 1;
};

/// True if a digit, a comma and a digit follow each other: numbers with decimal commas.
bool hasDecimalComma(std::string_view text);

/// Reads a number in the given byte order. @param bytes at least sizeof(T) of them
template <class T>
T readBytes(const char* bytes, std::endian order) {
    char own[sizeof(T)];
    std::memcpy(own, bytes, sizeof(T));
    if (order != std::endian::native) {
        std::reverse(own, own + sizeof(T));
    }
    T value;
    std::memcpy(&value, own, sizeof(T));
    return value;
}

}  // namespace toile::io
