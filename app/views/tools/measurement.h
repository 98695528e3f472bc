// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "app/views/tools/cloth_snapper.h"
#include "core/garment/piece.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::app {

/// A length on the garment and in the pattern, mm.
struct MeasuredLength {
    double onCloth = 0;
    std::optional<double> flat{};  ///< where the piece is flat

    /// What the flat one is longer than the other, as a part of it.
    std::optional<double> difference() const {
        return flat && onCloth > 0 ? std::optional(*flat / onCloth - 1) : std::nullopt;
    }
};

/// Straight from place to place in the pattern.
double flatDistance(const Piece& piece, const Points2& Q, const SurfacePoint& from,
                    const SurfacePoint& to);

/// Along the outline, or along the rim of a hole, the shorter way round on the garment; none where
/// the places are not on one and the same loop.
/// @param Q  the piece's flat points; null where it is not flat
std::optional<MeasuredLength> alongOutline(const Piece& piece, const Points2* Q,
                                           const SurfacePoint& from, const SurfacePoint& to);

}  // namespace toile::app
