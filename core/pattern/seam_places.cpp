// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/seam_places.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/geometry/line.h"
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

}  // namespace toile
