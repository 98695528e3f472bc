// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "core/formats/tables/pattern_match.h"

namespace toile::app {

struct ReferenceLines;

/// The pattern of somebody else, or of ours, that the pieces are compared with.
struct ReferenceFile {
    std::filesystem::path path{};  ///< absolute; empty: there is none
    /// As it was read; null where it could not be. Never null without a path.
    std::shared_ptr<const PatternFile> file{};

    bool operator==(const ReferenceFile&) const = default;
};

/// How that lies on a pattern: which pieces are which, and where. Immutable.
struct ReferenceMatch {
    std::shared_ptr<const Pattern> pattern{};   ///< not null
    std::shared_ptr<const PatternFile> file{};  ///< not null
    PatternMatch match{};
    std::shared_ptr<const ReferenceLines> lines{};  ///< of the sure pairs; not null
};

/// Whether there is no doubt which piece of the file is meant, and its line is laid on ours.
bool isSure(const PieceMatch& pair);
/// The pair that the piece is in, sure or not; null where it is in none. Logarithmic.
const PieceMatch* pairOf(const PatternMatch& match, int piece);

}  // namespace toile::app
