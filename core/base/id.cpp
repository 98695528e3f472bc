// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/id.h"

#include <charconv>

#define XXH_INLINE_ALL  // include the code here: no library to link
#include <xxhash.h>

namespace toile {
namespace {

constexpr std::string_view kKind = "xxh64:";
constexpr std::size_t kDigits = 16;

/// Parses 16 hexadecimal digits.
std::optional<std::uint64_t> numberOf(std::string_view text) {
    if (text.size() != kDigits) {
        return std::nullopt;
    }
    std::uint64_t id = 0;
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, id, 16);
    return read.ec == std::errc{} && read.ptr == end ? std::optional(id) : std::nullopt;
}

}  // namespace

std::uint64_t contentHash(std::string_view bytes) {
    return XXH64(bytes.data(), bytes.size(), 0);
}

std::uint64_t hashOf(std::initializer_list<std::uint64_t> numbers) {
    const std::uint64_t hash =
        contentHash({reinterpret_cast<const char*>(numbers.begin()), 8 * numbers.size()});
    return hash == 0 ? 1 : hash;
}

std::string idText(std::uint64_t id) {
    char digits[kDigits];
    const auto written = std::to_chars(digits, digits + kDigits, id, 16);
    const auto count = static_cast<std::size_t>(written.ptr - digits);
    return std::string(kDigits - count, '0') + std::string(digits, count);
}

std::optional<std::uint64_t> parseId(std::string_view text) {
    const auto id = numberOf(text);
    return id && *id != 0 ? id : std::nullopt;
}

std::string hashText(std::uint64_t hash) {
    return std::string(kKind) + idText(hash);
}

std::optional<std::uint64_t> parseHash(std::string_view text) {
    return text.starts_with(kKind) ? numberOf(text.substr(kKind.size())) : std::nullopt;
}

}  // namespace toile
