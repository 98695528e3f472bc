// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/piece_table.h"

#include <algorithm>
#include <cmath>

#include "app/render/colour_map.h"

namespace toile {

namespace {

/// Unbleached cotton, as a toile is made of.
constexpr Rgb kPlainCloth{226, 217, 200};

}  // namespace

PieceTable makePieceTable(const Scene& scene, const std::set<int>& selection,
                          const SheetPlaces& places, bool coloured) {
    const int count = static_cast<int>(scene.pieces.size());
    PieceTable table;
    table.height = std::max(1, (kTexelsPerPiece * count + kPieceTableWidth - 1) / kPieceTableWidth);
    table.texels.assign(
        static_cast<std::size_t>(4) * kPieceTableWidth * static_cast<std::size_t>(table.height),
        0.0F);
    for (int i = 0; i < count; ++i) {
        const PieceScene& piece = scene.pieces[static_cast<std::size_t>(i)];
        const SheetPlace& place = placeOf(places, i);
        const Rgb own = coloured ? pieceColour(place.colour) : kPlainCloth;
        const Rgb colour = piece.flat ? own : neutralColour();
        const int flags =
            (selection.count(i) != 0 ? kPieceSelected : 0) | (piece.flat ? kPieceFlat : 0);
        float* texel = table.texels.data() + static_cast<std::size_t>(i) * 4 * kTexelsPerPiece;
        texel[0] = static_cast<float>(colour.r) / 255.0F;
        texel[1] = static_cast<float>(colour.g) / 255.0F;
        texel[2] = static_cast<float>(colour.b) / 255.0F;
        texel[3] = static_cast<float>(flags);
        const Eigen::Matrix2d linear = place.placement.linear();
        for (int k = 0; k < 4; ++k) {
            texel[4 + k] = static_cast<float>(linear.data()[k]);  // column by column
        }
        texel[8] = static_cast<float>(place.placement.offset.x());
        texel[9] = static_cast<float>(place.placement.offset.y());
        texel[10] = static_cast<float>(std::cos(place.grain));
        texel[11] = static_cast<float>(std::sin(place.grain));
    }
    return table;
}

}  // namespace toile
