// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/readers/pdf_lexer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace toile {
namespace {

using Kind = PdfValue::Kind;

bool isBlank(char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '\f' || c == '\0';
}

bool isDelimiter(char c) {
    return std::string_view("()<>[]{}/%").find(c) != std::string_view::npos;
}

bool isRegular(char c) {
    return !isBlank(c) && !isDelimiter(c);
}

int hexDigit(char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

PdfValue textValue(Kind kind, std::string text) {
    return {.kind = kind, .text = std::move(text)};
}

}  // namespace

const PdfValue* PdfValue::find(std::string_view key) const {
    const auto at = std::ranges::find(keys, key);
    return kind != Kind::Dictionary || at == keys.end()
               ? nullptr
               : &items[static_cast<std::size_t>(at - keys.begin())];
}

void PdfLexer::skipBlanks() {
    while (at_ < bytes_.size() && (isBlank(bytes_[at_]) || bytes_[at_] == '%')) {
        if (bytes_[at_] == '%') {
            while (at_ < bytes_.size() && bytes_[at_] != '\n' && bytes_[at_] != '\r') {
                ++at_;
            }
        } else {
            ++at_;
        }
    }
}

std::optional<PdfValue> PdfLexer::value(int depth) {
    skipBlanks();
    if (at_ >= bytes_.size() || depth > kDeepestPdfValue) {
        return std::nullopt;
    }
    switch (peek()) {
        case '[':
            ++at_;
            return listed(depth, false);
        case '<':
            if (peek(1) != '<') {
                return hexadecimal();
            }
            at_ += 2;
            return listed(depth, true);
        case '(':
            return literal();
        case '/':
            return name();
        case ')':
        case '>':
        case ']':
        case '{':
        case '}':
            return std::nullopt;
        default:
            return wordOrNumber();
    }
}

std::optional<PdfValue> PdfLexer::listed(int depth, bool isDictionary) {
    PdfValue list{.kind = isDictionary ? Kind::Dictionary : Kind::Array};
    while (true) {
        skipBlanks();
        if (isDictionary && peek() == '>' && peek(1) == '>') {
            at_ += 2;
            return list;
        }
        if (!isDictionary && peek() == ']') {
            ++at_;
            return list;
        }
        if (isDictionary) {
            std::optional<PdfValue> key = value(depth + 1);
            if (!key || key->kind != Kind::Name) {
                return std::nullopt;
            }
            list.keys.push_back(std::move(key->text));
        }
        std::optional<PdfValue> item = value(depth + 1);
        if (!item) {
            return std::nullopt;
        }
        list.items.push_back(std::move(*item));
    }
}

std::optional<PdfValue> PdfLexer::literal() {
    std::string text;
    int open = 0;
    while (at_ < bytes_.size()) {
        const char c = bytes_[at_++];
        if (c == '\\' && at_ < bytes_.size()) {
            text += bytes_[at_++];
            continue;
        }
        open += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (open == 0) {
            return textValue(Kind::String, text.substr(1));
        }
        text += c;
    }
    return std::nullopt;
}

std::optional<PdfValue> PdfLexer::hexadecimal() {
    ++at_;
    std::string text;
    int high = -1;
    while (at_ < bytes_.size()) {
        const char c = bytes_[at_++];
        if (c == '>') {
            return textValue(Kind::String, std::move(text));
        }
        const int digit = hexDigit(c);
        if (digit < 0) {
            if (isBlank(c)) {
                continue;
            }
            return std::nullopt;
        }
        if (high < 0) {
            high = digit;
        } else {
            text += static_cast<char>(16 * high + digit);
            high = -1;
        }
    }
    return std::nullopt;
}

std::optional<PdfValue> PdfLexer::name() {
    const std::size_t start = ++at_;
    while (at_ < bytes_.size() && isRegular(bytes_[at_])) {
        ++at_;
    }
    return textValue(Kind::Name, std::string(bytes_.substr(start, at_ - start)));
}

std::optional<PdfValue> PdfLexer::wordOrNumber() {
    const std::size_t start = at_;
    while (at_ < bytes_.size() && isRegular(bytes_[at_])) {
        ++at_;
    }
    const std::string_view word = bytes_.substr(start, at_ - start);
    double number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(number)) {
        return textValue(Kind::Word, std::string(word));
    }
    const bool isReference =
        hasReferences_ && word.find('.') == std::string_view::npos && takeReference();
    return PdfValue{.kind = isReference ? Kind::Reference : Kind::Number, .number = number};
}

/// After a whole number: another one and "R".
bool PdfLexer::takeReference() {
    const std::size_t before = at_;
    skipBlanks();
    const std::size_t digits = at_;
    while (peek() >= '0' && peek() <= '9') {
        ++at_;
    }
    const bool hasDigits = at_ > digits;
    skipBlanks();
    if (hasDigits && peek() == 'R' && !isRegular(peek(1))) {
        ++at_;
        return true;
    }
    at_ = before;
    return false;
}

}  // namespace toile
