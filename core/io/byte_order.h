// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>

namespace toile::io {

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
