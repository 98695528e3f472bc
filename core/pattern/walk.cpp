// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/walk.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/pattern/trueing.h"
#include "core/seam/seam_measure.h"

namespace toile {
namespace {

WalkStation stationAt(const SeamMatch& at, int notch = -1) {
    WalkStation station;
    station.at = at;
    station.notch = notch;
    return station;
}

/// The ends of a seam and its notches. A notch at an end is merged with that end.
std::vector<WalkStation> stationsOf(const Seam& seam, const std::vector<Notch>& notches) {
    std::vector<WalkStation> stations{stationAt(seam.matches.front())};
    WalkStation end = stationAt(seam.matches.back());
    for (std::size_t k = 0; k < notches.size(); ++k) {
        const int notch = static_cast<int>(k);
        if (notches[k].share <= 0) {
            stations.front().notch = notch;
        } else if (notches[k].share >= 1) {
            end.notch = notch;
        } else {
            stations.push_back(stationAt(notches[k].at, notch));
        }
    }
    stations.push_back(end);
    return stations;
}

void measure(std::vector<WalkStation>& stations, const Seam& seam, const DrawnLoop& left,
             const DrawnLoop& right) {
    WalkedLengths before;
    for (WalkStation& station : stations) {
        const WalkedLengths here = walkedTo(seam, left, right, station.at);
        station.left = here.left - before.left;
        station.right = here.right - before.right;
        station.ease = here.ease - before.ease;
        before = here;
    }
}

/// Without the ease that is spread evenly.
WalkedLengths lengthsTo(const Seam& seam, const DrawnLoop& left, const DrawnLoop& right,
                        const SeamMatch& place) {
    const SeamMatch& start = seam.matches.front();
    return {std::abs(left.flatAt(place.left) - left.flatAt(start.left)),
            std::abs(right.flatAt(place.right) - right.flatAt(start.right)),
            std::abs(left.targetAt(place.left) - left.targetAt(start.left)) -
                std::abs(right.targetAt(place.right) - right.targetAt(start.right))};
}

}  // namespace

WalkedLengths walkedTo(const Seam& seam, const DrawnLoop& left, const DrawnLoop& right,
                       const SeamMatch& place) {
    WalkedLengths walked = lengthsTo(seam, left, right, place);
    const WalkedLengths whole = lengthsTo(seam, left, right, seam.matches.back());
    walked.ease += (easeOf(seam) * whole.right - whole.ease) *
                   (shareOf(seam, place) - shareOf(seam, seam.matches.front()));
    return walked;
}

double SeamWalk::largestError() const {
    double largest = 0;
    for (const WalkStation& station : stations) {
        largest = std::max(largest, std::abs(station.error()));
    }
    return largest;
}

std::vector<SeamWalk> walkSeams(const Garment& garment, const PieceResults& results,
                                const std::vector<OutlineSegments>& segments,
                                const std::vector<std::vector<Notch>>& notches) {
    DrawnLoops loops(results);
    std::vector<SeamWalk> walks;
    std::map<std::pair<int, bool>, double> kinks;  // by seam and end
    const auto turnAt = [&](const OutlineCorner& corner) -> double {
        return drawnTurn(*results[corner.piece], segments[corner.piece].turnPoints[corner.point]);
    };
    for (const SeamEnd& end : findSeamEnds(garment, segments, {})) {
        kinks[{end.seam, end.atEnd}] = kinkOf(turnAt(end.left), turnAt(end.right));
    }
    for (std::size_t s = 0; s < garment.seams.seams.size(); ++s) {
        const Seam& seam = garment.seams.seams[s];
        if (seam.matches.empty() || !loops.isFlat(seam.left) || !loops.isFlat(seam.right)) {
            continue;
        }
        SeamWalk walk{static_cast<int>(s)};
        walk.stations = stationsOf(seam, notches[s]);
        measure(walk.stations, seam, loops.of(seam.left), loops.of(seam.right));
        for (const bool atEnd : {false, true}) {
            if (const auto known = kinks.find({walk.seam, atEnd}); known != kinks.end()) {
                (atEnd ? walk.stations.back() : walk.stations.front()).kink = known->second;
            }
        }
        walks.push_back(std::move(walk));
    }
    return walks;
}

WalkedGarment walkGarment(const Garment& garment, const PieceResults& results,
                          const LineSettings& lines, const Symmetry* symmetry) {
    const std::vector<OutlineSegments> segments =
        findSegments(garment, exactResults(garment, results), lines);
    WalkedGarment walked;
    walked.notches =
        findNotches(garment, results, segments, lines.notches.value_or(NotchRules{}), symmetry);
    walked.walks = walkSeams(garment, results, segments, walked.notches);
    return walked;
}

}  // namespace toile
