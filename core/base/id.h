// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <initializer_list>
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

/// Identifies a thing among all of its kind in a document, through undo, saving, loading and
/// reading again: it is derived from the thing's origin, never from its name or its position in a
/// list. Zero means none.
template <class Kind>
struct Id {
    std::uint64_t value = 0;

    explicit operator bool() const { return value != 0; }
    bool operator==(const Id&) const = default;
    bool operator<(const Id& other) const { return value < other.value; }
};

using FileId = Id<struct SourceFile>;
using PieceId = Id<struct Piece>;
using SeamId = Id<struct Seam>;
using CutId = Id<struct UserCut>;
/// A rim of a piece as it was divided, or a cut: the lines that seams run along.
using LineId = Id<struct EdgeOrigin>;

/// A hash of numbers in this order; never 0, the same on every machine of one byte order. Pure.
std::uint64_t hashOf(std::initializer_list<std::uint64_t> numbers);

/// 16 hexadecimal digits.
std::string idText(std::uint64_t id);
/// Parses the text of an id; nothing if it has another form.
std::optional<std::uint64_t> parseId(std::string_view text);

template <class Kind>
std::string idText(Id<Kind> id) {
    return idText(id.value);
}

}  // namespace toile
