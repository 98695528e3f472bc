// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/export/json.h"
#include "core/pattern/fair_outline.h"
#include "core/pattern/trueing.h"
#include "core/quality/closed_line.h"

namespace toile {
namespace {

/// What the outline turns by at a turn point as it is drawn: where there is no line, exactly.
double drawnTurn(const PieceResult& result, const TurnPoint& point) {
    if (!result.flat || !result.flat->line) {
        return point.turn;
    }
    const FlatLine& line = *result.flat->line;
    const ClosedLine byArc(line.points, line.arc);
    const auto apart = [&](double arc) { return byArc.apart(arc, point.at); };
    const auto nearest = std::ranges::min_element(line.arc.begin(), line.arc.end() - 1, {}, apart);
    const double turn = byArc.turnAt(static_cast<int>(nearest - line.arc.begin()));
    return point.turn + std::remainder(turn - point.turn, 2 * std::numbers::pi);
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
    PieceResults exact;
    for (const auto& result : results) {
        exact.push_back(result->exact ? result->exact : result);
    }
    const auto segments = findSegments(garment, exact, {});
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

}  // namespace toile
