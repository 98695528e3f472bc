// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <vector>

#include "app/render/scene.h"
#include "app/render/sheet_places.h"

namespace toile {

/// What may change per piece without touching the meshes, as the shaders look it up: three RGBA
/// texels per piece, in rows of `kPieceTableWidth` texels:
/// (red, green, blue, flags), the columns of the placement's 2 x 2 matrix, and (offset x, offset y,
/// the grain's direction in the piece's own coordinates: x, y).
inline constexpr int kPieceTableWidth = 2048;
inline constexpr int kTexelsPerPiece = 3;

enum PieceFlag { kPieceSelected = 1, kPieceFlat = 2 };

struct PieceTable {
    int height = 1;
    std::vector<float> texels;  ///< 4 x kPieceTableWidth x height
};

/// @param coloured  pieces have colours of their own; else all that are flat have a plain one
PieceTable makePieceTable(const Scene& scene, const std::set<int>& selection,
                          const SheetPlaces& places, bool coloured = true);

}  // namespace toile
