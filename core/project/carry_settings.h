// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/project/piece_settings.h"

namespace toile {

/// What a piece of one version of a garment has from the version before.
struct CarriedFrom {
    int piece = -1;                 ///< index into the pieces before; -1: it is new
    bool same = false;              ///< the very same piece, with the same flat coordinates
    std::vector<Anchor> anchors{};  ///< where not the same
    std::uint64_t flat = 0;         ///< which flat points these are of, as in PieceSettings
    PieceId partOf{};               ///< as in PieceSettings
};

/// At most as many anchors are kept of a piece that is to be flattened anew.
inline constexpr int kMaxAnchors = 128;

/// Which piece each one comes from (`predecessors`): both parts of a cut piece know the whole.
/// @param settings, results  one per piece of `before`; results may be null or left out
/// @return one per piece of `after`  Cost: linear in the meshes, and that of `predecessors`. Pure.
std::vector<CarriedFrom> carriedFrom(const Garment& before,
                                     const std::vector<PieceSettings>& settings,
                                     const PieceResults& results, const Garment& after);

/// What was said about the pieces before, for those after; as nobody had said anything where a
/// piece is new. Places are fitted once the pieces are flat (`anchoredSettings`).
/// @param settings  one per piece before  Cost: negligible. Pure.
std::vector<PieceSettings> carriedSettings(const std::vector<CarriedFrom>& from,
                                           const std::vector<PieceSettings>& settings);

/// The same for what is kept by id: a piece that is known keeps what was said about it.
/// @param before  one per piece before
void carrySettings(SettingsById& settings, const std::vector<PieceSettings>& before,
                   const std::vector<CarriedFrom>& from, const Garment& after);

}  // namespace toile
