// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/readable_name.h"

#include <cstddef>

namespace toile {
namespace {

/// Length of the UTF-8 sequence at `i`, or 0 where there is no valid one: no overlong forms, no
/// surrogates, nothing beyond U+10FFFF.
std::size_t sequenceLength(std::string_view bytes, std::size_t i) {
    const auto at = [&](std::size_t k) -> unsigned {
        return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u;
    };
    const unsigned lead = at(i);
    const std::size_t length = lead < 0x80                    ? 1
                               : lead >= 0xC2 && lead <= 0xDF ? 2
                               : lead >= 0xE0 && lead <= 0xEF ? 3
                               : lead >= 0xF0 && lead <= 0xF4 ? 4
                                                              : 0;
    for (std::size_t k = 1; k < length; ++k) {
        if ((at(i + k) & 0xC0u) != 0x80) {
            return 0;
        }
    }
    const unsigned second = at(i + 1);
    const bool outside = (lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) ||
                         (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second > 0x8F);
    return outside ? 0 : length;
}

bool isUtf8(std::string_view bytes) {
    for (std::size_t i = 0, length = 0; i < bytes.size(); i += length) {
        length = sequenceLength(bytes, i);
        if (length == 0) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::string readableName(std::string_view bytes) {
    const bool latin1 = !isUtf8(bytes);
    std::string name;
    name.reserve(bytes.size());
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7F) {
            name += ' ';
        } else if (latin1 && byte >= 0x80) {
            name += static_cast<char>(0xC0 | (byte >> 6));
            name += static_cast<char>(0x80 | (byte & 0x3F));
        } else {
            name += c;
        }
    }
    return name;
}

}  // namespace toile
