// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/usd_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace toile {
namespace {

// These texts are in namespace `toile`, where the window looks up their translations.
constexpr const char* kNoUsd = translatable("it is not USD text");
constexpr const char* kNotUnderstood = translatable("it has a syntax error");

Error malformedUsdText(int line, const char* what) {
    return {ErrorCode::MalformedFile, {}, worded("line %1: %2", {figure(line), worded(what)})};
}

}  // namespace
}  // namespace toile

namespace toile::io {
namespace {

constexpr int kDeepest = 64;              // prims within prims
constexpr double kFarthestNumber = 1e12;  // largest size of any number

/// Reads words, strings and bracketed values.
class UsdText {
public:
    explicit UsdText(std::string_view text) : text_(text) {}

    bool atEnd() { return peek() == '\0'; }

    /// The next significant character; 0 at the end.
    char peek() {
        skipBlanks();
        return at_ < text_.size() ? text_[at_] : '\0';
    }

    bool take(char wanted) {
        if (peek() != wanted) {
            return false;
        }
        ++at_;
        return true;
    }

    /// A run of characters other than USD's own marks.
    std::string word() {
        skipBlanks();
        const std::size_t from = at_;
        while (at_ < text_.size() && !isMark(text_[at_])) {
            ++at_;
        }
        return std::string(text_.substr(from, at_ - from));
    }

    /// A string in "a", 'a' or triple quotes.
    std::optional<std::string> quoted() {
        const char quote = peek();
        if (quote != '"' && quote != '\'') {
            return {};
        }
        const std::string thrice(3, quote);
        const bool isLong = text_.substr(at_, 3) == thrice;
        const std::string_view end = isLong ? std::string_view(thrice) : text_.substr(at_, 1);
        at_ += end.size();
        std::string out;
        while (at_ < text_.size() && text_.substr(at_, end.size()) != end) {
            at_ += text_[at_] == '\\' && at_ + 1 < text_.size() ? 1 : 0;
            out += text_[at_++];
        }
        if (at_ >= text_.size()) {
            return {};
        }
        at_ += end.size();
        return out;
    }

    /// From a bracket to its closing one, both included; strings may contain brackets.
    std::optional<std::string> bracketed(char open, char close) {
        if (peek() != open) {
            return {};
        }
        const std::size_t from = at_;
        int depth = 0;
        while (!atEnd()) {
            const char c = text_[at_];
            if (c == '"' || c == '\'') {
                if (!quoted()) {
                    return {};
                }
                continue;
            }
            if (c == '@') {
                if (!asset()) {
                    return {};
                }
                continue;
            }
            depth += c == open ? 1 : c == close ? -1 : 0;
            ++at_;
            if (depth == 0) {
                return std::string(text_.substr(from, at_ - from));
            }
        }
        return {};
    }

    /// The name of another file: @a.usd@.
    std::optional<std::string> asset() {
        if (!take('@')) {
            return {};
        }
        const std::size_t end = text_.find('@', at_);
        if (end == std::string_view::npos) {
            return {};
        }
        return std::string(text_.substr(std::exchange(at_, end + 1), end - at_));
    }

    int line() const {
        return static_cast<int>(std::count(
                   text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n')) +
               1;
    }

private:
    static bool isMark(char c) {
        return std::string_view(" \t\r\n\"'=(){}<>,;#@").find(c) != std::string_view::npos;
    }

    void skipBlanks() {
        while (at_ < text_.size()) {
            if (text_[at_] == '#') {
                at_ = std::min(text_.find('\n', at_), text_.size());
            } else if (std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos) {
                ++at_;
            } else {
                return;
            }
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

std::optional<std::string> valueOf(UsdText& text) {
    switch (text.peek()) {
        case '"':
        case '\'':
            return text.quoted();
        case '@':
            return text.asset();
        case '[':
            return text.bracketed('[', ']');
        case '(':
            return text.bracketed('(', ')');
        case '<':
            return text.bracketed('<', '>');
        case '{':
            return text.bracketed('{', '}');
        default: {
            std::string word = text.word();
            return word.empty() ? std::nullopt : std::optional(std::move(word));
        }
    }
}

bool isSpecifier(std::string_view word) {
    return word == "def" || word == "over" || word == "class";
}

bool readPrim(UsdText& text, UsdPrim& prim, int depth);

/// Reads the value after a name and '='.
bool readValue(UsdText& text, const std::string& name, UsdPrim& prim) {
    auto value = valueOf(text);
    if (!value) {
        return false;
    }
    prim.attributes[name] = std::move(*value);
    if (text.peek() == '(') {
        auto metadata = text.bracketed('(', ')');
        if (!metadata) {
            return false;
        }
        prim.metadata[name] = std::move(*metadata);
    }
    return true;
}

/// Reads the content between the braces of a prim. Attributes declared without a value are dropped,
/// and so are variants, since no variant is selected.
bool readContent(UsdText& text, UsdPrim& prim, int depth) {
    while (!text.take('}')) {
        std::string word = text.word();
        if (word.empty()) {
            if (text.take(';') || text.bracketed('(', ')')) {
                continue;
            }
            return false;
        }
        if (text.take('=')) {
            if (!readValue(text, word, prim)) {
                return false;
            }
        } else if (isSpecifier(word)) {
            UsdPrim& child = prim.children.emplace_back();
            child.specifier = std::move(word);
            if (!readPrim(text, child, depth + 1)) {
                return false;
            }
        } else if (word == "variantSet") {
            if (!text.quoted() || !text.take('=') || !text.bracketed('{', '}')) {
                return false;
            }
        }
    }
    return true;
}

/// Reads a prim after "def".
bool readPrim(UsdText& text, UsdPrim& prim, int depth) {
    if (depth > kDeepest) {
        return false;
    }
    prim.type = text.word();
    auto name = text.quoted();
    if (!name || (text.peek() == '(' && !text.bracketed('(', ')')) || !text.take('{')) {
        return false;
    }
    prim.name = std::move(*name);
    return readContent(text, prim, depth);
}

/// Parses the brackets at the beginning of a file, without comments.
UsdValues metadataOf(std::string_view brackets) {
    UsdText text(brackets.substr(1, brackets.size() - 2));
    UsdValues values;
    while (!text.atEnd()) {
        const std::string word = text.word();
        if (word.empty()) {
            if (!text.take(';') && !text.quoted()) {
                break;
            }
        } else if (text.take('=')) {
            auto value = valueOf(text);
            if (!value) {
                break;
            }
            values[word] = std::move(*value);
        }
    }
    return values;
}

}  // namespace

const std::string* UsdPrim::find(std::string_view attribute) const {
    const auto found = attributes.find(attribute);
    return found == attributes.end() ? nullptr : &found->second;
}

const UsdPrim* UsdPrim::child(std::string_view called) const {
    const auto found = std::ranges::find(children, called, &UsdPrim::name);
    return found == children.end() ? nullptr : &*found;
}

Result<UsdStage> parseUsd(std::string_view bytes) {
    UsdText text(bytes);
    const auto malformed = [&text](const char* what) {
        return malformedUsdText(text.line(), what);
    };
    if (!bytes.starts_with("#usda 1.")) {
        return malformed(kNoUsd);
    }
    UsdStage stage;
    if (text.peek() == '(') {
        const auto metadata = text.bracketed('(', ')');
        if (!metadata) {
            return malformed(kNotUnderstood);
        }
        stage.metadata = metadataOf(*metadata);
    }
    while (!text.atEnd()) {
        UsdPrim& prim = stage.prims.emplace_back();
        prim.specifier = text.word();
        if (!isSpecifier(prim.specifier) || !readPrim(text, prim, 0)) {
            return malformed(kNotUnderstood);
        }
    }
    return stage;
}

std::optional<std::vector<double>> usdNumbers(const std::string* value) {
    if (!value) {
        return {};
    }
    std::vector<double> numbers;
    const char *at = value->data(), *const end = at + value->size();
    while (at < end) {
        if (std::string_view("[](), \t\r\n").find(*at) != std::string_view::npos) {
            ++at;
            continue;
        }
        double number = 0;
        const auto [next, error] = std::from_chars(at, end, number);
        if (error != std::errc() || !(std::abs(number) < kFarthestNumber)) {
            return {};
        }
        numbers.push_back(number);
        at = next;
    }
    return numbers;
}

std::optional<std::vector<double>> usdNumbersOf(const UsdPrim& prim, const std::string& attribute) {
    if (const std::string* value = prim.find(attribute)) {
        return usdNumbers(value);
    }
    // { 1: (0, 0, 0), 2: ... }
    const std::string* samples = prim.find(attribute + ".timeSamples");
    const std::size_t from = samples ? samples->find(':') : std::string::npos;
    if (from == std::string::npos) {
        return {};
    }
    std::size_t to = from + 1;
    for (int depth = 0; to < samples->size(); ++to) {
        const char c = (*samples)[to];
        if (depth == 0 && (c == ',' || c == '}')) {
            break;
        }
        depth += c == '(' || c == '[' ? 1 : c == ')' || c == ']' ? -1 : 0;
    }
    const std::string first = samples->substr(from + 1, to - from - 1);
    return usdNumbers(&first);
}

std::vector<std::string> usdStrings(std::string_view list) {
    std::vector<std::string> strings;
    UsdText text(list);
    if (!text.take('[')) {
        return strings;
    }
    while (auto string = text.quoted()) {
        strings.push_back(std::move(*string));
        text.take(',');
    }
    return strings;
}

}  // namespace toile::io
