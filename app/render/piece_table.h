// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <vector>

#include "app/render/scene.h"

namespace toile {

/// What may change per piece without touching the meshes, as the shaders look it up: two RGBA
/// texels per piece, (red, green, blue, flags) and (offset x, offset y, 0, 0), in rows of
/// `kPieceTableWidth` texels.
inline constexpr int kPieceTableWidth = 2048;

enum PieceFlag { kPieceSelected = 1, kPieceFlat = 2 };

struct PieceTable {
    int height = 1;
    std::vector<float> texels;  ///< 4 x kPieceTableWidth x height
};

PieceTable makePieceTable(const Scene& scene, const std::set<int>& selection);

}  // namespace toile
