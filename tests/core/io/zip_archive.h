// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace toile::test {

/// A file in an archive as its header tells it; packed by no method unless told otherwise.
struct ZipEntry {
    std::string name, bytes;
    bool encrypted = false;
    std::uint32_t statedSize = 0;  ///< other than that of the bytes; 0: theirs
    std::uint16_t method = 0;
};

inline std::uint32_t crc32Of(std::string_view bytes) {
    std::uint32_t crc = ~0U;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320U : 0U);
        }
    }
    return ~crc;
}

inline void put(std::string& out, std::uint32_t value, int bytes) {
    for (int k = 0; k < bytes; ++k) {
        out += static_cast<char>((value >> (8 * k)) & 0xFF);
    }
}

/// What the two headers of an entry have in common, from the version to the lengths.
inline void putCommon(std::string& out, const ZipEntry& entry) {
    const auto packed = static_cast<std::uint32_t>(entry.bytes.size());
    put(out, 20, 2);
    put(out, entry.encrypted ? 1 : 0, 2);
    put(out, entry.method, 2);
    put(out, 0x00210000, 4);  // the first day of 1980
    put(out, crc32Of(entry.bytes), 4);
    put(out, packed, 4);
    put(out, entry.statedSize != 0 ? entry.statedSize : packed, 4);
    put(out, static_cast<std::uint32_t>(entry.name.size()), 2);
    put(out, 0, 2);
}

/// A .zip archive, written by hand so that it can lie.
inline std::string zipOf(const std::vector<ZipEntry>& entries) {
    std::string out, directory;
    for (const ZipEntry& entry : entries) {
        const auto at = static_cast<std::uint32_t>(out.size());
        put(out, 0x04034B50, 4);
        putCommon(out, entry);
        out += entry.name + entry.bytes;
        put(directory, 0x02014B50, 4);
        put(directory, 20, 2);
        putCommon(directory, entry);
        put(directory, 0, 2);
        put(directory, 0, 4);
        put(directory, 0, 4);
        put(directory, at, 4);
        directory += entry.name;
    }
    const auto start = static_cast<std::uint32_t>(out.size());
    out += directory;
    put(out, 0x06054B50, 4);
    put(out, 0, 4);
    put(out, static_cast<std::uint32_t>(entries.size()), 2);
    put(out, static_cast<std::uint32_t>(entries.size()), 2);
    put(out, static_cast<std::uint32_t>(directory.size()), 4);
    put(out, start, 4);
    put(out, 0, 2);
    return out;
}

}  // namespace toile::test
