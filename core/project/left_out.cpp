// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/left_out.h"

#include <algorithm>
#include <utility>

#include "core/mesh/surface_area.h"

namespace toile {

PieceResults withoutLeftOut(PieceResults results, const Garment& garment,
                            const std::vector<PieceSettings>& settings) {
    for (std::size_t i = 0; i < std::min(results.size(), settings.size()); ++i) {
        const bool isOut = results[i] && isLeftOut(*results[i]);
        if (!settings[i].leftOut && isOut) {
            results[i] = nullptr;
        } else if (settings[i].leftOut && results[i] && !isOut) {
            auto out = std::make_shared<PieceResult>();
            out->piece = garment.pieces[i];
            out->options = results[i]->options;
            out->targets = results[i]->targets;
            out->error = Error{ErrorCode::LeftOut, subjectOf(*garment.pieces[i])};
            results[i] = std::move(out);
        }
    }
    return results;
}

double wornArea(const Piece& piece) {
    return surfaceArea(piece.mesh);
}

}  // namespace toile
