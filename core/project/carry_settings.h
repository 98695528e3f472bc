// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/project/piece_settings.h"

namespace toile {

/// What a piece takes over from the previous version of the garment.
struct CarriedFrom {
    int piece = -1;                 ///< index into the pieces before; -1: the piece is new
    bool same = false;              ///< the very same piece, with the same flat coordinates
    std::vector<Anchor> anchors{};  ///< empty if `same`
    std::uint64_t flat = 0;         ///< flat points of the anchors, as in PieceSettings
    PieceId partOf{};               ///< as in PieceSettings
};

/// At most so many anchors are stored for a piece that is to be flattened again.
inline constexpr int kMaxAnchors = 128;

/// The predecessor of each piece (`predecessors`); both parts of a cut piece have the whole one.
/// @param settings, results  one per piece of `before`; results may be null or empty
/// @return one per piece of `after`  Cost: linear in the meshes, and that of `predecessors`. Pure.
std::vector<CarriedFrom> carriedFrom(const Garment& before,
                                     const std::vector<PieceSettings>& settings,
                                     const PieceResults& results, const Garment& after);

/// Transfers settings to the pieces after an edit; new pieces get defaults. Placements are fitted
/// once the pieces are flat (`anchoredSettings`).
/// @param settings  one per piece before  Cost: negligible. Pure.
std::vector<PieceSettings> carriedSettings(const std::vector<CarriedFrom>& from,
                                           const std::vector<PieceSettings>& settings);

/// The same for settings stored by id: a known piece keeps its settings.
/// @param before  one per piece before
void carrySettings(SettingsById& settings, const std::vector<PieceSettings>& before,
                   const std::vector<CarriedFrom>& from, const Garment& after);

}  // namespace toile
