// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/seam_picking.h"

#include <algorithm>
#include <limits>

#include "core/geometry/segment.h"

namespace toile {

namespace {

/// How far beside a ray a segment passes, per mm of depth; infinite where it is out of reach.
double besides(const Ray& ray, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
               double farthest) {
    const Eigen::Vector3d edge = b - a, from = a - ray.origin;
    // The place of the segment nearest to the ray's line: both seen along the ray are points of a
    // plane, where it is a matter of a point and a segment.
    const Eigen::Vector3d edgeAcross = edge - edge.dot(ray.direction) * ray.direction;
    const Eigen::Vector3d fromAcross = from - from.dot(ray.direction) * ray.direction;
    const double t =
        nearestShare<Eigen::Vector3d>(Eigen::Vector3d::Zero(), fromAcross, fromAcross + edgeAcross);
    const double depth = (from + t * edge).dot(ray.direction);
    return depth > 0 && depth <= farthest ? (fromAcross + t * edgeAcross).norm() / depth
                                          : std::numeric_limits<double>::infinity();
}

/// False where no point of the box can be within the cone around the ray.
bool mayMeet(const Ray& ray, double slope, const Eigen::AlignedBox3d& box) {
    const Eigen::Vector3d middle = box.center() - ray.origin;
    const double radius = 0.5 * box.diagonal().norm(), depth = middle.dot(ray.direction);
    return (middle - depth * ray.direction).norm() <=
           radius + slope * std::max(0.0, depth + radius);
}

}  // namespace

std::optional<SeamHit> pickPatternSeam(const Scene& scene, const SheetPlaces& places,
                                       const Eigen::Vector2d& at, double radius,
                                       const SeamFilter& counts) {
    std::optional<SeamHit> nearest;
    const auto& lines = scene.patternLines;
    for (std::size_t s = 0; s < lines.runs.seams.size(); ++s) {
        if (counts && !counts(static_cast<int>(s))) {
            continue;
        }
        for (int side = 0; side < 2; ++side) {
            const VertexRun run = lines.runs.seams[s][static_cast<std::size_t>(side)];
            const SeamScene::Side& part = scene.seams[s].sides[static_cast<std::size_t>(side)];
            if (run.count < 2) {
                continue;
            }
            const Eigen::Vector2d local = placeOf(places, part.piece).placement.undone(at);
            if (part.flatBox.exteriorDistance(local) > radius) {
                continue;
            }
            for (std::uint32_t i = run.first + 1; i < run.first + run.count; ++i) {
                const double distance = distanceToSegment(local, flatPoint(lines.vertices[i - 1]),
                                                          flatPoint(lines.vertices[i]));
                if (distance <= radius && (!nearest || distance < nearest->distance)) {
                    nearest = {static_cast<int>(s), side, static_cast<int>(i - run.first) - 1,
                               distance};
                }
            }
        }
    }
    return nearest;
}

std::optional<SeamHit> pickGarmentSeam(const Scene& scene, const Ray& ray, double slope,
                                       double farthest, const SeamFilter& counts) {
    std::optional<SeamHit> nearest;
    const auto& lines = scene.garmentLines;
    for (std::size_t s = 0; s < lines.runs.seams.size(); ++s) {
        if ((counts && !counts(static_cast<int>(s))) || scene.seams[s].box.isEmpty() ||
            !mayMeet(ray, slope, scene.seams[s].box)) {
            continue;
        }
        for (int side = 0; side < 2; ++side) {
            const VertexRun run = lines.runs.seams[s][static_cast<std::size_t>(side)];
            for (std::uint32_t i = run.first + 1; i < run.first + run.count; ++i) {
                const double distance = besides(ray, wornPoint(lines.vertices[i - 1]),
                                                wornPoint(lines.vertices[i]), farthest);
                if (distance <= slope && (!nearest || distance < nearest->distance)) {
                    nearest = {static_cast<int>(s), side, static_cast<int>(i - run.first) - 1,
                               distance};
                }
            }
        }
    }
    return nearest;
}

}  // namespace toile
