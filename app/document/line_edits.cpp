// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/line_edits.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/garment/lineage.h"
#include "core/seam/seam_settings.h"

namespace toile::app {

namespace {

/// Of a place on a line: nearer to each other, two are one.
constexpr double kSameShare = 1e-7;
/// What has more than this part of another stretch is about it.
constexpr double kMost = 0.5;

bool isAbout(const SegmentSettings& said, const LineStretch& place) {
    return covered(place, said.place) > kMost && covered(said.place, place) > kMost;
}

}  // namespace

LineSettings withFairing(LineSettings lines) {
    if (!lines.fairing) {
        lines.fairing = Fairing{};
    }
    return lines;
}

LineSettings withSegment(LineSettings lines, const SegmentSettings& said) {
    std::erase_if(lines.segments,
                  [&said](const SegmentSettings& one) -> bool { return isAbout(one, said.place); });
    if (!said.saysNothing()) {
        lines.segments.push_back(said);
    }
    return lines;
}

LineSettings withoutLength(LineSettings lines, const LineStretch& place) {
    for (SegmentSettings& one : lines.segments) {
        if (isAbout(one, place)) {
            one.length.reset();
        }
    }
    std::erase_if(lines.segments, [](const SegmentSettings& one) { return one.saysNothing(); });
    return lines;
}

LineSettings withSeamEnd(LineSettings lines, const SeamGraph& graph, const SeamEnd& end,
                         bool trued) {
    std::erase_if(lines.seamEnds, [&](const SeamEndSettings& one) -> bool {
        return one.atEnd == end.atEnd && seamAt(graph, one.seam) == end.seam;
    });
    if (trued != (std::abs(end.kink) <= lines.trueBelow)) {
        lines.seamEnds.push_back(
            {graph.seams[static_cast<std::size_t>(end.seam)].place, end.atEnd, trued});
    }
    return lines;
}

std::optional<TurnPointSettings> turnPointAt(const Piece& piece, int at) {
    const EdgeOrigin* origin =
        originAt(piece.origins, piece.boundary[static_cast<std::size_t>(at)]);
    if (!origin) {
        return std::nullopt;
    }
    return TurnPointSettings{origin->line, origin->from, origin->from > origin->to};
}

LineSettings withTurnPoint(LineSettings lines, const TurnPointSettings& point) {
    bool isUndone = false;  // what is said now only takes back what was said before
    std::erase_if(lines.turnPoints, [&](const TurnPointSettings& one) -> bool {
        const bool isSame = one.line == point.line && one.reversed == point.reversed &&
                            std::abs(one.at - point.at) < kSameShare;
        isUndone = isUndone || (isSame && one.turns != point.turns);
        return isSame;
    });
    if (!isUndone) {
        lines.turnPoints.push_back(point);
    }
    return lines;
}

}  // namespace toile::app
