// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <filesystem>
#include <memory>

#include "core/formats/tables/pattern_match.h"

namespace toile::app {

struct ReferenceLines;

/// The reference pattern: a file that the pieces are compared with.
struct ReferenceFile {
    std::filesystem::path path{};  ///< absolute; empty: there is none
    /// Null if it could not be read, and without a path.
    std::shared_ptr<const PatternFile> file{};

    bool operator==(const ReferenceFile&) const = default;
};

/// How the reference pattern lies on a pattern: which pieces are which, and where. Immutable.
struct ReferenceMatch {
    std::shared_ptr<const Pattern> pattern{};   ///< not null
    std::shared_ptr<const PatternFile> file{};  ///< not null
    PatternMatch match{};
    std::shared_ptr<const ReferenceLines> lines{};  ///< of the sure pairs; not null
};

/// True if only one piece of the file fits, and its line is laid on ours.
inline bool isSure(const PieceMatch& pair) {
    return pair.rivals.empty() && !pair.lines.empty() && pair.lines.front().fit.laid.rows() > 0;
}

/// The pair that the piece is in, sure or not; null if it is in none. Logarithmic.
inline const PieceMatch* pairOf(const PatternMatch& match, int piece) {
    const auto found = std::ranges::lower_bound(match.pairs, piece, {}, &PieceMatch::piece);
    return found == match.pairs.end() || found->piece != piece ? nullptr : &*found;
}

}  // namespace toile::app
