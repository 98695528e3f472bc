// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/mirror_json.h"

#include <algorithm>
#include <cmath>

#include "core/pattern/fair_outline.h"

namespace toile {
namespace {

/// By how much a common length differs from the seam's own, at most, over its two sides, mm.
double changeOf(const Seam& seam, double factor) {
    const double longest = std::max(seam.length3d[0], seam.length3d[1]);
    return std::abs(factor - 1) * longest;
}

/// Pieces that mirror each other, each pair once, and those that are symmetric in themselves.
Json pairsJson(const Garment& garment, const PieceResults& results, const MirrorPieces& pieces) {
    Json pairs = Json::array();
    for (int p = 0; p < static_cast<int>(pieces.counterpart.size()); ++p) {
        const int other = pieces.counterpart[p];
        if (other < p) {
            continue;
        }
        Json names = Json::array({garment.pieces[p]->name});
        if (other != p) {
            names.push_back(garment.pieces[other]->name);
        }
        const PieceResult& result = *results[p];
        const bool isDrawn = result.flat && result.flat->line && result.plan;
        pairs.push_back({{"pieces", std::move(names)},
                         {"deviation", number(pieces.deviation[p])},
                         {"equal", isDrawn && result.plan->mirrored.has_value()}});
    }
    return pairs;
}

}  // namespace

Json symmetryJson(const Garment& garment, const PieceResults& results, const Symmetry& symmetry) {
    const MirrorPlane& plane = symmetry.plane;
    double change = 0;
    for (std::size_t s = 0; s < garment.seams.seams.size(); ++s) {
        change = std::max(change, changeOf(garment.seams.seams[s], symmetry.lengths.factor[s]));
    }
    Json without = Json::array();
    for (const int s : symmetry.lengths.withoutCounterpart()) {
        without.push_back(garment.seams.seams[s].name);
    }
    return {
        {"normal", {number(plane.normal.x()), number(plane.normal.y()), number(plane.normal.z())}},
        {"offset", number(plane.offset)},
        {"deviation", number(plane.deviation)},
        {"farthest", number(plane.farthest)},
        {"pairs", pairsJson(garment, results, symmetry.pieces)},
        {"largest_length_change", number(change)},
        {"without_counterpart", std::move(without)}};
}

}  // namespace toile
