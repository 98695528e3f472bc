// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace toile {

/// A value of a PDF file, or a word of it: an operator, "obj", "true".
struct PdfValue {
    enum class Kind { Number, Name, String, Array, Dictionary, Reference, Word };

    Kind kind = Kind::Word;
    double number = 0;                ///< of a reference that of the object
    std::string text{};               ///< of a name without its slash; of a string its bytes
    std::vector<PdfValue> items{};    ///< of a dictionary its values
    std::vector<std::string> keys{};  ///< of a dictionary, as many as values

    bool isName(std::string_view name) const { return kind == Kind::Name && text == name; }
    bool isWord(std::string_view word) const { return kind == Kind::Word && text == word; }
    /// Of a dictionary; null where it is none, or has no such key.
    const PdfValue* find(std::string_view key) const;
};

/// Reads values one after the other from any bytes: never beyond their end, nested no deeper than
/// kDeepestPdfValue. Cost: linear.
class PdfLexer {
public:
    /// @param hasReferences  whether "1 0 R" is one value, as in files but not in content streams
    PdfLexer(std::string_view bytes, bool hasReferences, std::size_t at = 0)
        : bytes_(bytes), hasReferences_(hasReferences), at_(at) {}

    /// None at the end, or where there is no value.
    std::optional<PdfValue> next() { return value(0); }
    std::size_t at() const { return at_; }

private:
    std::optional<PdfValue> value(int depth);
    std::optional<PdfValue> listed(int depth, bool isDictionary);
    std::optional<PdfValue> literal();
    std::optional<PdfValue> hexadecimal();
    std::optional<PdfValue> name();
    std::optional<PdfValue> wordOrNumber();
    bool takeReference();
    void skipBlanks();
    char peek(std::size_t ahead = 0) const {
        return at_ + ahead < bytes_.size() ? bytes_[at_ + ahead] : '\0';
    }

    std::string_view bytes_;
    bool hasReferences_;
    std::size_t at_;
};

inline constexpr int kDeepestPdfValue = 16;

}  // namespace toile
