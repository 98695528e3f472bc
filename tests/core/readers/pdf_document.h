// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "tests/core/readers/pdf_lexer.h"

namespace toile {

/// The objects of a PDF file as our own writer makes them: one table of offsets at the end, whole
/// streams, packed by Flate or not at all. Takes any bytes. Refers to them: they must outlive it.
class PdfDocument {
public:
    /// Errors: MalformedFile.
    static Result<PdfDocument> read(std::string_view bytes);

    const PdfValue& trailer() const { return trailer_; }
    /// The number of objects that the table lists, without the free one.
    std::size_t count() const { return offsets_.size(); }

    /// The object itself where it is a reference, else the same value. Errors: MalformedFile where
    /// the table leads elsewhere.
    Result<PdfValue> resolved(const PdfValue& value) const;
    /// The value of a key, resolved. Errors: MalformedFile where there is none.
    Result<PdfValue> entry(const PdfValue& dictionary, std::string_view key) const;
    /// The bytes of a stream, unpacked: at most kMaxUnpacked. Errors: MalformedFile.
    Result<std::string> stream(const PdfValue& reference) const;

    static constexpr std::size_t kMaxUnpacked = std::size_t{1} << 26;

private:
    struct Object {
        PdfValue value;
        std::size_t end = 0;  ///< behind the value, in the file
    };

    explicit PdfDocument(std::string_view bytes) : bytes_(bytes) {}
    Result<void> readTable(std::size_t at);
    Result<Object> object(double number) const;

    std::string_view bytes_;
    std::map<int, std::size_t> offsets_;
    mutable std::size_t lexed_ = 0;  ///< bytes of objects: a file may refer to one again and again
    PdfValue trailer_;
};

/// "the PDF file ...: what" as an Error.
Error malformedPdf(const std::string& what);

}  // namespace toile
