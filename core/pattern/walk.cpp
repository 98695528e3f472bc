// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/walk.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/pattern/seam_places.h"
#include "core/pattern/trueing.h"
#include "core/seam/seam_measure.h"

namespace toile {
namespace {

/// The ends of a seam and its notches. A notch at an end is that end.
std::vector<WalkStation> stationsOf(const Seam& seam, const std::vector<Notch>& notches) {
    std::vector<WalkStation> stations{{.at = seam.matches.front()}};
    WalkStation end{.at = seam.matches.back()};
    for (std::size_t k = 0; k < notches.size(); ++k) {
        const int notch = static_cast<int>(k);
        if (notches[k].share <= 0) {
            stations.front().notch = notch;
        } else if (notches[k].share >= 1) {
            end.notch = notch;
        } else {
            stations.push_back({.at = notches[k].at, .notch = notch});
        }
    }
    stations.push_back(end);
    return stations;
}

/// Ease is where the outlines are to have it; what the seam's ease has beyond that is spread.
void measure(std::vector<WalkStation>& stations, const Seam& seam, DrawnLoops& loops) {
    double spread = 0;
    for (std::size_t k = 1; k < stations.size(); ++k) {
        const SeamMatch &from = stations[k - 1].at, &to = stations[k].at;
        stations[k].left = loops.lengthOf(seam.left, from.left, to.left);
        stations[k].right = loops.lengthOf(seam.right, from.right, to.right);
        stations[k].ease = loops.targetOf(seam.left, from.left, to.left) -
                           loops.targetOf(seam.right, from.right, to.right);
        spread += easeOf(seam) * stations[k].right - stations[k].ease;
    }
    for (std::size_t k = 1; k < stations.size(); ++k) {
        stations[k].ease +=
            spread * (shareOf(seam, stations[k].at) - shareOf(seam, stations[k - 1].at));
    }
}

}  // namespace

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
    std::map<std::pair<int, bool>, double> kinks;  // by seam, at its end
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
        measure(walk.stations, seam, loops);
        for (const bool atEnd : {false, true}) {
            if (const auto known = kinks.find({walk.seam, atEnd}); known != kinks.end()) {
                (atEnd ? walk.stations.back() : walk.stations.front()).kink = known->second;
            }
        }
        walks.push_back(std::move(walk));
    }
    return walks;
}

}  // namespace toile
