// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "core/export/json.h"
#include "core/pattern/fair_outline.h"
#include "core/pattern/trueing.h"

namespace toile {
namespace {

/// Strain over pieces: the extremes, and the mean weighted by area. Null if no piece has any.
Json strainJson(const PieceResults& results, const std::vector<int>& pieces) {
    double least = std::numeric_limits<double>::infinity(), most = -least, sum = 0, area = 0;
    for (const int p : pieces) {
        const auto& q = results[p]->quality;
        if (!q || !q->strainMin || !q->strainMax || !q->strainMeanAbs) {
            least = most = sum = std::numeric_limits<double>::quiet_NaN();
            break;
        }
        least = std::min(least, *q->strainMin);
        most = std::max(most, *q->strainMax);
        sum += q->area3d * *q->strainMeanAbs;
        area += q->area3d;
    }
    return {{"strain_min", number(least)},
            {"strain_max", number(most)},
            {"strain_mean_abs", number(sum / area)}};
}

/// Strain as drawn, and with the exact outlines.
void addStrain(Json& json, const PieceResults& results, const std::vector<int>& pieces) {
    json.update(strainJson(results, pieces));
    json["exact"] = strainJson(exactResults(results), pieces);
}

bool isDrawnMirrored(const PieceResult& result) {
    return result.flat && result.flat->line && result.plan && result.plan->mirrored;
}

/// Pairs of mirrored pieces, each once, and pieces that are symmetric in themselves.
Json pairsJson(const Garment& garment, const PieceResults& results, const MirrorPieces& pieces) {
    Json pairs = Json::array();
    for (int p = 0; p < static_cast<int>(pieces.counterpart.size()); ++p) {
        const int other = pieces.counterpart[p];
        if (other < p) {
            continue;
        }
        const std::vector<int> both = other == p ? std::vector{p} : std::vector{p, other};
        Json names = Json::array();
        for (const int piece : both) {
            names.push_back(garment.pieces[piece]->name);
        }
        Json pair{{"pieces", std::move(names)},
                  {"deviation", number(pieces.deviation[p])},
                  {"equal", isDrawnMirrored(*results[p]) && isDrawnMirrored(*results[other])}};
        addStrain(pair, results, both);
        pairs.push_back(std::move(pair));
    }
    return pairs;
}

}  // namespace

Json lineJson(const PieceResult& result) {
    const FlatLine& line = *result.flat->line;
    const PieceQuality& exact = *result.exact->quality;
    return {{"smoothing", number(result.plan->smoothing)},
            {"farthest", number(line.farthest)},
            {"iterations", line.iterations},
            {"converged", line.converged},
            {"exact",
             {{"symmetric_dirichlet", number(exact.symmetricDirichlet)},
              {"strain_min", number(exact.strainMin)},
              {"strain_max", number(exact.strainMax)},
              {"strain_mean_abs", number(exact.strainMeanAbs)}}}};
}

Json seamEndsJson(const Garment& garment, const PieceResults& results) {
    const auto segments = findSegments(garment, exactResults(garment, results), {});
    const auto turnAt = [&](const OutlineCorner& corner) -> double {
        return drawnTurn(*results[corner.piece], segments[corner.piece].turnPoints[corner.point]);
    };
    Json ends = Json::array();
    for (const SeamEnd& end : findSeamEnds(garment, segments, {})) {
        ends.push_back({{"seam", garment.seams.seams[end.seam].name},
                        {"end", text(end.atEnd ? "end" : "start")},
                        {"kink_exact", number(end.kink)},
                        {"kink", number(kinkOf(turnAt(end.left), turnAt(end.right)))}});
    }
    return ends;
}

Json symmetryJson(const Garment& garment, const PieceResults& results, const Symmetry& symmetry) {
    const MirrorPlane& plane = symmetry.plane;
    const double change = largestChange(garment.seams, symmetry.lengths);
    Json without = Json::array();
    for (const int s : symmetry.lengths.withoutCounterpart()) {
        without.push_back(garment.seams.seams[s].name);
    }
    std::vector<int> mirrored;
    for (int p = 0; p < static_cast<int>(results.size()); ++p) {
        if (isDrawnMirrored(*results[p])) {
            mirrored.push_back(p);
        }
    }
    Json json{
        {"normal", {number(plane.normal.x()), number(plane.normal.y()), number(plane.normal.z())}},
        {"offset", number(plane.offset)},
        {"deviation", number(plane.deviation)},
        {"farthest", number(plane.farthest)},
        {"pairs", pairsJson(garment, results, symmetry.pieces)},
        {"largest_length_change", number(change)}};
    for (const UnequalPieces& one : symmetry.unequal) {
        json["unequal"].push_back(
            {{"pieces", {garment.pieces[one.piece]->name, garment.pieces[one.counterpart]->name}},
             {"seams",
              {garment.seams.seams[one.seam].name, garment.seams.seams[one.mirrored].name}},
             {"difference", number(one.difference)},
             {"tolerance", number(one.tolerance)}});
    }
    addStrain(json, results, mirrored);
    json["without_counterpart"] = std::move(without);
    return json;
}

}  // namespace toile
