// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/fair_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/cut/straighten.h"
#include "core/geometry/segment.h"

namespace toile::tailor {
namespace {

/// The point between two neighbours on a path. @param share  0 at the first
SurfacePoint between(const SurfaceLinks& links, const SurfacePoint& a, const SurfacePoint& b,
                     double share) {
    const int face = links.commonFace(a, b);
    const auto first = links.seenFrom(face, a), second = links.seenFrom(face, b);
    return {face, (1 - share) * first->barycentric + share * second->barycentric};
}

/// Both parts of a path. @param at  mm from its start
std::array<PathPolyline, 2> divided(const SurfaceLinks& links, const PathPolyline& path,
                                    double at) {
    std::array<PathPolyline, 2> parts;
    double before = 0;
    std::size_t k = 1;
    parts[0].points.push_back(path.points.front());
    for (; k < path.points.size(); ++k) {
        const double step = (positionOf(links.mesh(), path.points[k]) -
                             positionOf(links.mesh(), path.points[k - 1]))
                                .norm();
        if (before + step >= at || k + 1 == path.points.size()) {
            const double share = step > 0 ? std::clamp((at - before) / step, 0.0, 1.0) : 0;
            const SurfacePoint middle = between(links, path.points[k - 1], path.points[k], share);
            parts[0].points.push_back(middle);
            parts[1].points.push_back(middle);
            break;
        }
        before += step;
        parts[0].points.push_back(path.points[k]);
    }
    parts[1].points.insert(parts[1].points.end(),
                           path.points.begin() + static_cast<std::ptrdiff_t>(k), path.points.end());
    for (PathPolyline& part : parts) {
        part.length = measuredLength(links.mesh(), part);
    }
    return parts;
}

PathPolyline joined(PathPolyline first, const PathPolyline& second) {
    first.points.insert(first.points.end(), second.points.begin() + 1, second.points.end());
    first.length += second.length;
    return first;
}

double distanceTo(const std::vector<Eigen::Vector3d>& line, const Eigen::Vector3d& p) {
    double least = (line.front() - p).norm();
    for (std::size_t k = 1; k < line.size(); ++k) {
        least = std::min(least, geometry::distanceToSegment(p, line[k - 1], line[k]));
    }
    return least;
}

/// The fewest geodesics, one after the other, that stay near a way. Each is the shortest of all:
/// the way pulled tight may pass the bumps of uneven cloth on other sides, and turn far more.
std::vector<PathPolyline> geodesicsNear(const SurfaceLinks& links, std::span<const int> way,
                                        double near) {
    auto shortest = geodesicPath(links, links.atVertex(way.front()), links.atVertex(way.back()));
    PathPolyline path =
        shortest ? std::move(*shortest) : polylineOf(links, {way.begin(), way.end()});
    const std::vector<Eigen::Vector3d> line = positionsOf(links.mesh(), path);
    double most = near;
    std::size_t farthest = 0;
    for (std::size_t k = 1; k + 1 < way.size(); ++k) {
        const double distance = distanceTo(line, links.mesh().V.row(way[k]).transpose());
        if (distance > most) {
            most = distance;
            farthest = k;
        }
    }
    if (farthest == 0) {
        return {std::move(path)};
    }
    std::vector<PathPolyline> parts = geodesicsNear(links, way.first(farthest + 1), near);
    std::vector<PathPolyline> rest = geodesicsNear(links, way.subspan(farthest), near);
    std::ranges::move(rest, std::back_inserter(parts));
    return parts;
}

/// A path in parts of even length, none longer than a step.
std::vector<PathPolyline> inSteps(const SurfaceLinks& links, PathPolyline path, double step) {
    const int count = std::max(1, static_cast<int>(std::ceil(path.length / step)));
    const double each = path.length / count;
    std::vector<PathPolyline> parts;
    for (int k = 1; k < count; ++k) {
        auto [part, rest] = divided(links, path, each);
        parts.push_back(std::move(part));
        path = std::move(rest);
    }
    parts.push_back(std::move(path));
    return parts;
}

/// Shortens a line around every second of its inner points, and around the others, by turns.
void roundKinks(const SurfaceLinks& links, std::vector<PathPolyline>& parts, int roundings) {
    for (int round = 0; round < 2 * roundings; ++round) {
        for (auto k = static_cast<std::size_t>(1 + round % 2); k < parts.size(); k += 2) {
            const PathPolyline whole = straightened(links, joined(parts[k - 1], parts[k]));
            auto [before, after] = divided(links, whole, whole.length / 2);
            parts[k - 1] = std::move(before);
            parts[k] = std::move(after);
        }
    }
}

}  // namespace

std::vector<PathPolyline> fairPath(const SurfaceLinks& links, std::span<const int> way,
                                   const Fairness& fairness) {
    PathPolyline path;
    bool hasKinks = false;
    for (PathPolyline& part : geodesicsNear(links, way, fairness.near)) {
        hasKinks = !path.points.empty();
        path = hasKinks ? joined(std::move(path), part) : std::move(part);
    }
    std::vector<PathPolyline> parts = inSteps(links, std::move(path), fairness.step);
    if (hasKinks) {
        roundKinks(links, parts, fairness.roundings);
    }
    return parts;
}

}  // namespace toile::tailor
