// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace toile {

/// XXH64 of the bytes, seed 0, as its published specification defines it: detects changes of
/// a file at the speed of memory. No protection against forgery. Pure; linear.
std::uint64_t contentHash(std::string_view bytes);

/// "xxh64:ef46db3751d8e999": the kind and 16 hexadecimal digits.
std::string hashText(std::uint64_t hash);
/// Parses such a text; nothing if it has another form.
std::optional<std::uint64_t> parseHash(std::string_view text);

}  // namespace toile
