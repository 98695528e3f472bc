// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/content_hash.h"

#include <charconv>

#define XXH_INLINE_ALL  // into this file: nothing to link
#include <xxhash.h>

namespace toile {
namespace {

constexpr std::string_view kKind = "xxh64:";
constexpr std::size_t kDigits = 16;

}  // namespace

std::uint64_t contentHash(std::string_view bytes) {
    return XXH64(bytes.data(), bytes.size(), 0);
}

std::string hashText(std::uint64_t hash) {
    char digits[kDigits];
    const auto written = std::to_chars(digits, digits + kDigits, hash, 16);
    const auto count = static_cast<std::size_t>(written.ptr - digits);
    return std::string(kKind) + std::string(kDigits - count, '0') + std::string(digits, count);
}

std::optional<std::uint64_t> parseHash(std::string_view text) {
    if (!text.starts_with(kKind) || text.size() != kKind.size() + kDigits) {
        return std::nullopt;
    }
    text.remove_prefix(kKind.size());
    std::uint64_t hash = 0;
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, hash, 16);
    return read.ec == std::errc{} && read.ptr == end ? std::optional(hash) : std::nullopt;
}

}  // namespace toile
