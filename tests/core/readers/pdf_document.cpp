// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/readers/pdf_document.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <zlib.h>

namespace toile {
namespace {

using Kind = PdfValue::Kind;

/// A whole number that is not negative.
std::optional<std::size_t> wholeNumber(const std::optional<PdfValue>& value) {
    constexpr double kMost = 1e15;
    if (!value || value->kind != Kind::Number || !(value->number >= 0) || value->number > kMost ||
        value->number != std::floor(value->number)) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(value->number);
}

/// None where it is no such stream, or too long.
std::optional<std::string> inflated(std::string_view packed) {
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) {
        return std::nullopt;
    }
    std::string out;
    std::array<Bytef, 16384> chunk{}, given{};
    std::size_t used = 0;
    int state = Z_OK;
    while (state == Z_OK && out.size() <= PdfDocument::kMaxUnpacked) {
        if (stream.avail_in == 0) {
            const std::size_t more = std::min(given.size(), packed.size() - used);
            std::memcpy(given.data(), packed.data() + used, more);
            used += more;
            stream.next_in = given.data();
            stream.avail_in = static_cast<uInt>(more);
        }
        stream.next_out = chunk.data();
        stream.avail_out = static_cast<uInt>(chunk.size());
        state = inflate(&stream, Z_NO_FLUSH);
        out.insert(out.end(), chunk.begin(),
                   chunk.end() - static_cast<std::ptrdiff_t>(stream.avail_out));
    }
    inflateEnd(&stream);
    return state == Z_STREAM_END && out.size() <= PdfDocument::kMaxUnpacked
               ? std::optional(std::move(out))
               : std::nullopt;
}

}  // namespace

Error malformedPdf(const std::string& what) {
    return {ErrorCode::MalformedFile, {}, what};
}

Result<PdfDocument> PdfDocument::read(std::string_view bytes) {
    PdfDocument document(bytes);
    if (!bytes.starts_with("%PDF-1.")) {
        return malformedPdf("it does not begin as a PDF file");
    }
    constexpr std::string_view kStart = "startxref";
    const std::size_t start = bytes.rfind(kStart);
    const std::size_t marker = bytes.rfind("%%EOF");
    if (start == std::string_view::npos || marker == std::string_view::npos || marker < start) {
        return malformedPdf("it has no end");
    }
    PdfLexer lexer(bytes, true, start + kStart.size());
    const auto table = wholeNumber(lexer.next());
    if (!table || *table >= bytes.size()) {
        return malformedPdf("its table of objects is not to be found");
    }
    if (const auto done = document.readTable(*table); !done) {
        return done.error();
    }
    return document;
}

Result<void> PdfDocument::readTable(std::size_t at) {
    PdfLexer lexer(bytes_, true, at);
    const auto word = lexer.next();
    const auto first = wholeNumber(lexer.next()), count = wholeNumber(lexer.next());
    if (!word || !word->isWord("xref") || first != std::size_t{0} || !count) {
        return malformedPdf("its table of objects does not begin");
    }
    for (std::size_t k = 0; k < *count; ++k) {
        const auto offset = wholeNumber(lexer.next()), generation = wholeNumber(lexer.next());
        const auto use = lexer.next();
        if (!offset || !generation || !use || !(use->isWord("n") || use->isWord("f"))) {
            return malformedPdf("its table of objects ends early");
        }
        if (use->isWord("n")) {
            offsets_[static_cast<int>(k)] = *offset;
        }
    }
    const auto end = lexer.next();
    auto trailer = lexer.next();
    if (!end || !end->isWord("trailer") || !trailer || trailer->kind != Kind::Dictionary) {
        return malformedPdf("it has no trailer");
    }
    trailer_ = std::move(*trailer);
    return {};
}

Result<PdfDocument::Object> PdfDocument::object(double number) const {
    const auto at = offsets_.find(number >= 0 && number <= static_cast<double>(offsets_.size())
                                      ? static_cast<int>(number)
                                      : -1);
    if (at == offsets_.end() || at->second >= bytes_.size()) {
        return malformedPdf("an object is missing");
    }
    PdfLexer lexer(bytes_, true, at->second);
    const auto own = wholeNumber(lexer.next()), generation = wholeNumber(lexer.next());
    const auto word = lexer.next();
    if (own != static_cast<std::size_t>(number) || generation != std::size_t{0} || !word ||
        !word->isWord("obj")) {
        return malformedPdf("object " + std::to_string(at->first) + " is not where it should be");
    }
    auto value = lexer.next();
    lexed_ += lexer.at() - at->second;
    if (!value || lexed_ > kMaxUnpacked) {
        return malformedPdf("object " + std::to_string(at->first) +
                            (value ? " is too much" : " is cut short"));
    }
    return Object{std::move(*value), lexer.at()};
}

Result<PdfValue> PdfDocument::resolved(const PdfValue& value) const {
    if (value.kind != Kind::Reference) {
        return value;
    }
    auto found = object(value.number);
    if (!found) {
        return found.error();
    }
    return std::move(found->value);
}

Result<PdfValue> PdfDocument::entry(const PdfValue& dictionary, std::string_view key) const {
    const PdfValue* value = dictionary.find(key);
    if (!value) {
        return malformedPdf("there is no /" + std::string(key));
    }
    return resolved(*value);
}

Result<std::string> PdfDocument::stream(const PdfValue& reference) const {
    if (reference.kind != Kind::Reference) {
        return malformedPdf("a stream is missing");
    }
    const auto found = object(reference.number);
    if (!found) {
        return found.error();
    }
    const PdfValue* length = found->value.find("Length");
    const auto size = wholeNumber(length ? std::optional(*length) : std::nullopt);
    constexpr std::string_view kWord = "stream\n";
    std::size_t start = found->end;
    while (start < bytes_.size() && bytes_[start] == '\n') {
        ++start;
    }
    if (!size || !bytes_.substr(start).starts_with(kWord) ||
        *size > bytes_.size() - start - kWord.size() ||
        !bytes_.substr(start + kWord.size() + *size).starts_with("\nendstream")) {
        return malformedPdf("a stream is cut short");
    }
    const std::string_view packed = bytes_.substr(start + kWord.size(), *size);
    const PdfValue* filter = found->value.find("Filter");
    if (!filter) {
        return std::string(packed);
    }
    auto out = filter->isName("FlateDecode") ? inflated(packed) : std::nullopt;
    if (!out) {
        return malformedPdf("a stream cannot be unpacked");
    }
    return std::move(*out);
}

}  // namespace toile
