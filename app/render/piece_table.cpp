// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/piece_table.h"

#include <algorithm>

#include "app/render/colour_map.h"

namespace toile {

PieceTable makePieceTable(const Scene& scene, const std::set<int>& selection) {
    const int count = static_cast<int>(scene.pieces.size());
    PieceTable table;
    table.height = std::max(1, (2 * count + kPieceTableWidth - 1) / kPieceTableWidth);
    table.texels.assign(
        static_cast<std::size_t>(4) * kPieceTableWidth * static_cast<std::size_t>(table.height),
        0.0F);
    for (int i = 0; i < count; ++i) {
        const PieceScene& piece = scene.pieces[static_cast<std::size_t>(i)];
        const Rgb colour = piece.flat ? pieceColour(i) : neutralColour();
        const int flags =
            (selection.count(i) != 0 ? kPieceSelected : 0) | (piece.flat ? kPieceFlat : 0);
        float* texel = table.texels.data() + static_cast<std::size_t>(i) * 8;
        texel[0] = static_cast<float>(colour.r) / 255.0F;
        texel[1] = static_cast<float>(colour.g) / 255.0F;
        texel[2] = static_cast<float>(colour.b) / 255.0F;
        texel[3] = static_cast<float>(flags);
        texel[4] = static_cast<float>(piece.offset.x());
        texel[5] = static_cast<float>(piece.offset.y());
    }
    return table;
}

}  // namespace toile
