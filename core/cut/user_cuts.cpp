// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/user_cuts.h"

#include <bit>
#include <limits>
#include <map>
#include <set>

#include "core/cut/surface_paths.h"
#include "core/geometry/segment.h"

namespace toile {
namespace {

/// A path's end whose weight against a rim edge is below this reaches the rim.
constexpr double kReachesRim = 0.1;

SurfacePoint ontoNearRim(const SurfaceLinks& links, SurfacePoint point) {
    for (int k = 0; k < 3; ++k) {
        const int v = links.mesh().F(point.face, k);
        if (point.barycentric[k] > 1 - kReachesRim && !links.isInner(v)) {
            return links.atVertex(v);
        }
    }
    for (int k = 0; k < 3; ++k) {
        double& weight = point.barycentric[(k + 2) % 3];
        if (links.twin(3 * point.face + k) < 0 && weight < kReachesRim) {
            weight = 0;
            point.barycentric /= point.barycentric.sum();
        }
    }
    return point;
}

/// The rim's point closest to p; without a face if there is no rim.
SurfacePoint nearestOnRim(const SurfaceLinks& links, const Eigen::Vector3d& p, double& distance) {
    SurfacePoint best;
    distance = std::numeric_limits<double>::infinity();
    for (int use = 0; use < 3 * links.faceCount(); ++use) {
        if (links.twin(use) >= 0) {
            continue;
        }
        const Eigen::Vector3d a = links.mesh().V.row(links.tail(use));
        const Eigen::Vector3d b = links.mesh().V.row(links.head(use));
        const double t = geometry::nearestShare(p, a, b);
        const double d = (a + t * (b - a) - p).norm();
        if (d < distance) {
            distance = d;
            best = {use / 3, Eigen::Vector3d::Zero()};
            best.barycentric[use % 3] = 1 - t;
            best.barycentric[(use % 3 + 1) % 3] = t;
        }
    }
    return best;
}

/// Moves the end of a dart that is closer to the rim onto it. False if there is no rim.
bool putOnRim(const SurfaceLinks& links, std::vector<SurfacePoint>& points) {
    double first = 0;
    double last = 0;
    const SurfacePoint atFirst =
        nearestOnRim(links, positionOf(links.mesh(), points.front()), first);
    const SurfacePoint atLast = nearestOnRim(links, positionOf(links.mesh(), points.back()), last);
    if (atFirst.face < 0) {
        return false;
    }
    (first <= last ? points.front() : points.back()) = first <= last ? atFirst : atLast;
    return true;
}

int nearestVertex(const MeshArrays& mesh, const SurfacePoint& point) {
    int heaviest = 0;
    point.barycentric.maxCoeff(&heaviest);
    return mesh.F(point.face, heaviest);
}

}  // namespace

void giveIds(std::vector<UserCut>& cuts) {
    std::set<CutId> taken;
    for (UserCut& cut : cuts) {
        if (cut.id && !taken.insert(cut.id).second) {
            cut.id = {};  // ids must be unique
        }
    }
    std::map<std::uint64_t, std::uint64_t> alike;
    for (UserCut& cut : cuts) {
        if (cut.id) {
            continue;
        }
        std::uint64_t hash =
            hashOf({static_cast<std::uint64_t>(cut.kind), cut.alongEdges ? 1U : 0U});
        for (const Eigen::Vector3d& point : cut.points) {
            for (const double coordinate : point) {
                hash = hashOf({hash, std::bit_cast<std::uint64_t>(coordinate)});
            }
        }
        do {
            cut.id.value = hashOf({hash, alike[hash]++});
        } while (!taken.insert(cut.id).second);
    }
}

Result<PathPolyline> pathOfCut(const SurfaceLinks& links, const SurfacePoint& from,
                               const SurfacePoint& to, bool alongEdges, const Progress& progress) {
    return alongEdges ? edgePath(links, nearestVertex(links.mesh(), from),
                                 nearestVertex(links.mesh(), to), progress)
                      : geodesicPath(links, from, to, progress);
}

Result<std::vector<SurfacePoint>> pointsOfCut(const SurfaceLinks& links,
                                              const NearestSurface& nearest, const UserCut& cut) {
    const int needed = cut.kind == UserCut::Kind::Loop ? 3 : 2;
    if (static_cast<int>(cut.points.size()) < needed) {
        return cutError(subjectOf(cut), worded("it needs %1 points or more", {figure(needed)}));
    }
    std::vector<SurfacePoint> points;
    for (const Eigen::Vector3d& p : cut.points) {
        if (!p.allFinite()) {
            return cutError(subjectOf(cut), worded("a point is not finite"));
        }
        points.push_back(nearest.find(p));
    }
    if (cut.kind == UserCut::Kind::Path) {
        points.front() = ontoNearRim(links, points.front());
        points.back() = ontoNearRim(links, points.back());
    } else if (cut.kind == UserCut::Kind::Dart && !putOnRim(links, points)) {
        return cutError(subjectOf(cut),
                        worded("a dart must start at the rim, but the piece has none"));
    }
    return points;
}

Result<PathPolyline> traceUserCut(const SurfaceLinks& links, const NearestSurface& nearest,
                                  const UserCut& cut, const Progress& progress) {
    auto placed = pointsOfCut(links, nearest, cut);
    if (!placed) {
        return placed.error();
    }
    std::vector<SurfacePoint>& points = *placed;
    if (cut.kind == UserCut::Kind::Loop) {
        points.push_back(points.front());
    }
    PathPolyline whole;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const auto part = pathOfCut(links, points[i - 1], points[i], cut.alongEdges, progress);
        if (!part) {
            Error error = part.error();
            error.subject = subjectOf(cut);
            return error;
        }
        whole.points.insert(whole.points.end(), part->points.begin() + (i == 1 ? 0 : 1),
                            part->points.end());
        whole.length += part->length;
    }
    return whole;
}

}  // namespace toile
