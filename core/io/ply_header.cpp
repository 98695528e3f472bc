// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ply_header.h"

#include <charconv>
#include <utility>

#include "core/base/words.h"
#include "core/io/text_cursor.h"

namespace toile::io {
namespace {

constexpr Word<PlyType> kTypes[] = {
    {PlyType::Int8, "char"},      {PlyType::Int8, "int8"},       {PlyType::UInt8, "uchar"},
    {PlyType::UInt8, "uint8"},    {PlyType::Int16, "short"},     {PlyType::Int16, "int16"},
    {PlyType::UInt16, "ushort"},  {PlyType::UInt16, "uint16"},   {PlyType::Int32, "int"},
    {PlyType::Int32, "int32"},    {PlyType::UInt32, "uint"},     {PlyType::UInt32, "uint32"},
    {PlyType::Float32, "float"},  {PlyType::Float32, "float32"}, {PlyType::Float64, "double"},
    {PlyType::Float64, "float64"}};
constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};  // in the order of the types
constexpr Word<PlyFormat> kFormats[] = {{PlyFormat::Ascii, "ascii"},
                                        {PlyFormat::LittleEndian, "binary_little_endian"},
                                        {PlyFormat::BigEndian, "binary_big_endian"}};

bool isWhole(PlyType type) {
    return type != PlyType::Float32 && type != PlyType::Float64;
}

class HeaderReader {
public:
    HeaderReader(std::string_view bytes, const std::string& name)
        : bytes_(bytes), name_(name), cursor_(bytes) {}

    Result<PlyHeader> read() {
        if (word() != "ply") {
            return malformed("the file does not begin with \"ply\"");
        }
        bool hasFormat = false;
        for (cursor_.nextLine(); !cursor_.atEnd(); cursor_.nextLine()) {
            const std::string_view keyword = word();
            if (keyword == "end_header") {
                if (!hasFormat) {
                    return malformed("the header names no format");
                }
                return finish();
            }
            Result<void> line;
            if (keyword == "format") {
                line = readFormat();
                hasFormat = true;
            } else if (keyword == "element") {
                line = readElement();
            } else if (keyword == "property") {
                line = readProperty();
            } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
                line = malformed("an unknown keyword in the header");
            }
            if (!line) {
                return line.error();
            }
        }
        return malformed("the header has no end");
    }

private:
    std::string_view word() {
        cursor_.skipBlanks();
        return cursor_.token();
    }

    Result<void> readFormat() {
        const auto format = parseWord(kFormats, word());
        if (!format) {
            return malformed("an unknown format");
        }
        header_.format = *format;
        return {};
    }

    Result<void> readElement() {
        PlyElement element;
        element.name = word();
        const std::string_view count = word();
        const char* end = count.data() + count.size();
        const auto [last, status] = std::from_chars(count.data(), end, element.count);
        if (count.empty() || status != std::errc() || last != end) {
            return malformed("an element without a count");
        }
        header_.elements.push_back(std::move(element));
        return {};
    }

    Result<void> readProperty() {
        std::optional<PlyType> countType;
        std::string_view type = word();
        if (type == "list") {
            countType = parseWord(kTypes, word());
            if (!countType || !isWhole(*countType)) {
                return malformed("a list whose count has no whole type");
            }
            type = word();
        }
        const std::optional<PlyType> known = parseWord(kTypes, type);
        const std::string_view name = word();
        if (!known || name.empty() || header_.elements.empty()) {
            return malformed("a property that cannot be read");
        }
        header_.elements.back().properties.push_back({std::string(name), *known, countType});
        return {};
    }

    Result<PlyHeader> finish() {
        skipLastLineEnd();
        header_.bodyOffset = cursor_.offset();
        header_.bodyLine = cursor_.line();
        for (const PlyElement& element : header_.elements) {
            const std::size_t least = leastBytes(element);
            if (least > 0 && element.count > (cursor_.bytesLeft() + 1) / least) {
                return malformed("the header promises " + std::to_string(element.count) + " x \"" +
                                 element.name + "\", " + std::to_string(cursor_.bytesLeft()) +
                                 " bytes follow");
            }
        }
        return std::move(header_);
    }

    /// If lines end in CR alone, a byte 10 after the last one is data.
    void skipLastLineEnd() {
        const std::size_t firstEnd = bytes_.find_first_of("\r\n");
        const bool crAlone =
            bytes_[firstEnd] == '\r' && bytes_.substr(firstEnd + 1, 1) != std::string_view("\n");
        if (crAlone && cursor_.at('\r')) {
            cursor_.skip('\r');
        } else {
            cursor_.nextLine();
        }
    }

    /// Minimum size of one record: the bytes of its numbers, or a digit and a blank for each.
    std::size_t leastBytes(const PlyElement& element) const {
        std::size_t bytes = 0;
        for (const PlyProperty& property : element.properties) {
            bytes += header_.format == PlyFormat::Ascii
                         ? 2
                         : sizeOf(property.countType.value_or(property.type));
        }
        return bytes;
    }

    Error malformed(const std::string& what) const {
        return {ErrorCode::MalformedFile, Subject::file(name_),
                "line " + std::to_string(cursor_.line()) + ": " + what};
    }

    std::string_view bytes_;
    const std::string& name_;
    TextCursor cursor_;
    PlyHeader header_;
};

}  // namespace

std::size_t sizeOf(PlyType type) {
    return kSizes[static_cast<std::size_t>(type)];
}

Result<PlyHeader> readPlyHeader(std::string_view bytes, const std::string& name) {
    return HeaderReader(bytes, name).read();
}

}  // namespace toile::io
