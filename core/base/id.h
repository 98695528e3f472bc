// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace toile {

/// Tells one thing from every other of its kind in a document, through undo, saving, loading and
/// reading again: it follows from where the thing comes from, never from its name or its place in
/// a list. Zero is nobody's.
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
/// A rim of a piece as it was divided, or a cut: what seams run along.
using LineId = Id<struct EdgeOrigin>;

/// A hash of numbers in this order; never 0, the same on every machine of one byte order. Pure.
std::uint64_t hashOf(std::initializer_list<std::uint64_t> numbers);

/// 16 hexadecimal digits.
std::string idText(std::uint64_t id);
/// The id of such a text; nothing where it is none.
std::optional<std::uint64_t> parseId(std::string_view text);

template <class Kind>
std::string idText(Id<Kind> id) {
    return idText(id.value);
}

}  // namespace toile
