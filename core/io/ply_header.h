// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/io/byte_order.h"
#include "core/io/text_cursor.h"

namespace toile::io {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };

enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

/// Bytes of a number in a binary file: 1, 2, 4 or 8.
std::size_t sizeOf(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type;
    std::optional<PlyType> countType;  ///< set if it is a list
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

/// The contents that a PLY file declares.
struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    std::size_t bodyOffset = 0;  ///< of the first byte after the header
    int bodyLine = 1;            ///< line number there
};

/// Reads the header. Every count is limited to the bytes after the header, so that callers can
/// reserve memory for it. `name` is the file, for messages.
/// Errors: MalformedFile, with the line.
Result<PlyHeader> readPlyHeader(std::string_view bytes, const std::string& name);

/// The body of a PLY file as consecutive numbers, as text or as bytes; both classes have the same
/// interface. Every type's values are exact in a double.

class PlyTextNumbers {
public:
    PlyTextNumbers(std::string_view bytes, const PlyHeader& header)
        : cursor_(bytes.substr(header.bodyOffset)),
          bodyOffset_(header.bodyOffset),
          bodyLine_(header.bodyLine) {}

    /// The next number; NaN for a word that is not a number. False at the end of the file.
    bool next(PlyType, double& value) {
        cursor_.skipSpace();
        first_ = bodyOffset_ + cursor_.offset();
        if (cursor_.atEnd()) {
            return false;
        }
        if (!cursor_.readDouble(value)) {
            value = std::numeric_limits<double>::quiet_NaN();
            unreadable_ = cursor_.token();
        }
        return true;
    }

    /// Position of the last number for messages: its line, from 1.
    int place(std::size_t) const { return bodyLine_ + cursor_.line() - 1; }

    /// Offset in the file of the last number's first byte, and of the byte after it.
    std::size_t first() const { return first_; }

    std::size_t last() const { return bodyOffset_ + cursor_.offset(); }

    /// The last word that was not a number; empty if there was none since the last call.
    std::string_view takeUnreadable() { return std::exchange(unreadable_, {}); }

private:
    TextCursor cursor_;
    std::size_t bodyOffset_;
    int bodyLine_;
    std::size_t first_ = 0;
    std::string_view unreadable_;
};

class PlyByteNumbers {
public:
    PlyByteNumbers(std::string_view bytes, const PlyHeader& header)
        : bytes_(bytes.substr(header.bodyOffset)),
          order_(header.format == PlyFormat::BigEndian ? std::endian::big : std::endian::little) {}

    bool next(PlyType type, double& value) {
        const std::size_t size = sizeOf(type);
        if (bytes_.size() < size) {
            return false;
        }
        value = number(type);
        bytes_.remove_prefix(size);
        return true;
    }

    /// Position of the last number for messages: its record, from 1.
    int place(std::size_t record) const { return static_cast<int>(record) + 1; }

    /// Numbers in bytes have no text.
    std::size_t first() const { return 0; }

    std::size_t last() const { return 0; }

    std::string_view takeUnreadable() { return {}; }

private:
    double number(PlyType type) const {
        const char* at = bytes_.data();
        switch (type) {
            case PlyType::Int8:
                return readBytes<std::int8_t>(at, order_);
            case PlyType::UInt8:
                return readBytes<std::uint8_t>(at, order_);
            case PlyType::Int16:
                return readBytes<std::int16_t>(at, order_);
            case PlyType::UInt16:
                return readBytes<std::uint16_t>(at, order_);
            case PlyType::Int32:
                return readBytes<std::int32_t>(at, order_);
            case PlyType::UInt32:
                return readBytes<std::uint32_t>(at, order_);
            case PlyType::Float32:
                return static_cast<double>(readBytes<float>(at, order_));
            case PlyType::Float64:
                return readBytes<double>(at, order_);
        }
        return 0;
    }

    std::string_view bytes_;
    std::endian order_;
};

}  // namespace toile::io
