// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/walk.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "core/geometry/line.h"
#include "core/pattern/notch_mark.h"
#include "core/pattern/trueing.h"
#include "core/quality/measures.h"
#include "core/seam/seam_measure.h"

namespace toile {
namespace {

double shareOnSide(const SeamSide& side, double arc) {
    const double length = side.end - side.start;
    return length != 0 ? (arc - side.start) / length : 0;
}

/// Finds the place where a function that rises from match to match has a value.
template <class Rising>
SeamMatch placeWhere(const Seam& seam, const Rising& rising, double value) {
    const std::vector<SeamMatch>& all = seam.matches;
    const auto next =
        std::ranges::partition_point(all, [&](const SeamMatch& m) { return rising(m) < value; });
    if (next == all.begin() || next == all.end()) {
        return next == all.begin() ? all.front() : all.back();
    }
    const SeamMatch &a = *(next - 1), &b = *next;
    const double t = (value - rising(a)) / (rising(b) - rising(a));
    return {(1 - t) * a.left + t * b.left, (1 - t) * a.right + t * b.right};
}

DrawnLoop drawnLoop(const PieceResult& result, const SeamSide& side) {
    const std::vector<int>& loop = loopOf(side, *result.piece);
    const Eigen::VectorXd in3d = boundaryLengths3d(result.piece->mesh.V, loop);
    const bool hasTargets = side.loop == 0 && result.targets.lengths.size() > 0;
    const Points2 points = result.flat->Q(loop, Eigen::all);
    const auto byArc = geometry::Line::closed(points, geometry::arcOf(in3d));
    const auto target =
        geometry::Line::closed(points, geometry::arcOf(hasTargets ? result.targets.lengths : in3d));
    const auto& line = result.flat->line;
    if (!line || side.loop != 0) {
        return {byArc, target, target, geometry::Line::closed(points)};
    }
    std::vector<double> places = line->arc;
    for (double& place : places) {
        place = byArc.placeOn(target, place);
    }
    return {byArc, target, geometry::Line::closed(line->points, std::move(places)),
            geometry::Line::closed(line->points)};
}

}  // namespace

double shareOf(const Seam& seam, const SeamMatch& place) {
    return 0.5 * (shareOnSide(seam.left, place.left) + shareOnSide(seam.right, place.right));
}

SeamMatch placeAtShare(const Seam& seam, double share) {
    return placeWhere(
        seam, [&seam](const SeamMatch& m) { return shareOf(seam, m); }, share);
}

SeamMatch placeOnSide(const Seam& seam, bool onRight, double arc) {
    const SeamSide& side = onRight ? seam.right : seam.left;
    const auto share = [&](const SeamMatch& m) -> double {
        return shareOnSide(side, onRight ? m.right : m.left);
    };
    return placeWhere(seam, share, shareOnSide(side, arc));
}

bool DrawnLoops::isFlat(const SeamSide& side) const {
    const auto at = static_cast<std::size_t>(side.piece);
    return side.piece >= 0 && at < results_.size() && results_[at] && results_[at]->flat;
}

const DrawnLoop& DrawnLoops::of(const SeamSide& side) {
    const std::pair key(side.piece, side.loop);
    auto known = loops_.find(key);
    if (known == loops_.end()) {
        known = loops_.emplace(key, drawnLoop(*results_[side.piece], side)).first;
    }
    return known->second;
}

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
                          const Pattern& pattern, const std::optional<NotchRules>& rules) {
    WalkedGarment walked;
    walked.notches = findNotches(garment, results, pattern.exactSegments,
                                 rules.value_or(NotchRules{}), pattern.symmetry.get());
    walked.walks = walkSeams(garment, results, pattern.exactSegments, walked.notches);
    return walked;
}

SeamRoll::SeamRoll(Seam seam, DrawnLoops& loops)
    : seam_(std::move(seam)), left_(loops.of(seam_.left)), right_(loops.of(seam_.right)) {}

double SeamRoll::directionAt(const SeamSide& side, const DrawnLoop& loop, double arc) const {
    const double at = loop.flatAt(arc);
    double from = at - kHalfChord, to = at + kHalfChord;
    if (!seam_.closed) {
        const auto [low, high] = std::minmax({loop.flatAt(side.start), loop.flatAt(side.end)});
        from = std::clamp(from, low, high);
        to = std::clamp(to, low, high);
    }
    if (side.reversed) {
        std::swap(from, to);
    }
    return directionTo(loop.flat.pointAt(from).transpose(), loop.flat.pointAt(to).transpose());
}

RolledPlace SeamRoll::at(double share) const {
    RolledPlace rolled{.at = placeAtShare(seam_, share)};
    Placement& motion = rolled.motion;
    motion.turn = wrappedAngle(directionAt(seam_.left, left_, rolled.at.left) -
                               directionAt(seam_.right, right_, rolled.at.right));
    motion.offset = left_.pointAt(rolled.at.left).transpose() -
                    motion.applied(right_.pointAt(rolled.at.right).transpose());
    rolled.walked = walkedTo(seam_, left_, right_, rolled.at);
    return rolled;
}

}  // namespace toile
