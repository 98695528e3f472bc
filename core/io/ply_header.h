// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace toile {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };

enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

/// Bytes of a number in a binary file: 1, 2, 4 or 8.
std::size_t sizeOf(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type;
    std::optional<PlyType> countType;  ///< there where it is a list
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

/// What a PLY file says it holds.
struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    std::size_t bodyOffset = 0;  ///< of the first byte after the header
    int bodyLine = 1;            ///< line number there
};

/// Reads the header. Every count is one that the bytes after the header can hold, so that memory
/// may be set aside for it. `name` is the file, for messages.
/// Errors: MalformedFile, with the line.
Result<PlyHeader> readPlyHeader(std::string_view bytes, const std::string& name);

}  // namespace toile
