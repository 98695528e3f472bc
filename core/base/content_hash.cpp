// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/content_hash.h"

#include <bit>
#include <charconv>

namespace toile {
namespace {

constexpr std::string_view kKind = "xxh64:";
constexpr std::size_t kDigits = 16;

// The five primes of the specification.
constexpr std::uint64_t kPrime1 = 0x9E3779B185EBCA87U;
constexpr std::uint64_t kPrime2 = 0xC2B2AE3D27D4EB4FU;
constexpr std::uint64_t kPrime3 = 0x165667B19E3779F9U;
constexpr std::uint64_t kPrime4 = 0x85EBCA77C2B2AE63U;
constexpr std::uint64_t kPrime5 = 0x27D4EB2F165667C5U;

constexpr std::size_t kStripe = 32;

/// Little-endian, whatever the machine; compilers make one load of it.
template <class Word>
Word wordAt(const char* at) {
    Word word = 0;
    for (std::size_t i = 0; i < sizeof(Word); ++i) {
        word |= static_cast<Word>(static_cast<unsigned char>(at[i])) << (8 * i);
    }
    return word;
}

std::uint64_t round(std::uint64_t lane, std::uint64_t word) {
    return std::rotl(lane + word * kPrime2, 31) * kPrime1;
}

std::uint64_t merged(std::uint64_t hash, std::uint64_t lane) {
    return (hash ^ round(0, lane)) * kPrime1 + kPrime4;
}

std::uint64_t overStripes(const char*& at, const char* end) {
    std::uint64_t a = kPrime1 + kPrime2, b = kPrime2, c = 0, d = 0 - kPrime1;
    for (; static_cast<std::size_t>(end - at) >= kStripe; at += kStripe) {
        a = round(a, wordAt<std::uint64_t>(at));
        b = round(b, wordAt<std::uint64_t>(at + 8));
        c = round(c, wordAt<std::uint64_t>(at + 16));
        d = round(d, wordAt<std::uint64_t>(at + 24));
    }
    std::uint64_t hash = std::rotl(a, 1) + std::rotl(b, 7) + std::rotl(c, 12) + std::rotl(d, 18);
    for (const std::uint64_t lane : {a, b, c, d}) {
        hash = merged(hash, lane);
    }
    return hash;
}

std::uint64_t overRest(std::uint64_t hash, const char* at, const char* end) {
    for (; end - at >= 8; at += 8) {
        hash ^= round(0, wordAt<std::uint64_t>(at));
        hash = std::rotl(hash, 27) * kPrime1 + kPrime4;
    }
    if (end - at >= 4) {
        hash ^= wordAt<std::uint32_t>(at) * kPrime1;
        hash = std::rotl(hash, 23) * kPrime2 + kPrime3;
        at += 4;
    }
    for (; at < end; ++at) {
        hash ^= static_cast<unsigned char>(*at) * kPrime5;
        hash = std::rotl(hash, 11) * kPrime1;
    }
    return hash;
}

std::uint64_t avalanched(std::uint64_t hash) {
    hash = (hash ^ (hash >> 33)) * kPrime2;
    hash = (hash ^ (hash >> 29)) * kPrime3;
    return hash ^ (hash >> 32);
}

}  // namespace

std::uint64_t contentHash(std::string_view bytes) {
    const char* at = bytes.data();
    const char* end = at + bytes.size();
    const std::uint64_t start = bytes.size() >= kStripe ? overStripes(at, end) : kPrime5;
    return avalanched(overRest(start + bytes.size(), at, end));
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
