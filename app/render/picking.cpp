// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/picking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/geometry/segment.h"

namespace toile::app {

namespace {

/// Slab test: where the ray enters the box, rounded down (a flat piece has a box without depth).
/// Infinite if it misses the box or enters beyond `farthest`.
double distanceTo(const Ray& ray, const geometry::TriangleTree<3>::Box& box, double farthest) {
    constexpr double kSlack = 1e-9;
    double from = 0, to = farthest;
    for (int k = 0; k < 3; ++k) {
        const double inverse = 1.0 / ray.direction[k];  // infinite if parallel, which still works
        const auto at = static_cast<std::size_t>(k);
        // Choose by sign, so that the inverted empty boxes at the tree's end are missed.
        const auto& [first, last] =
            inverse < 0 ? std::tie(box.high, box.low) : std::tie(box.low, box.high);
        const double a = (static_cast<double>(first[at]) - ray.origin[k]) * inverse;
        const double b = (static_cast<double>(last[at]) - ray.origin[k]) * inverse;
        if (std::isnan(a) || std::isnan(b)) {
            continue;  // parallel and inside the slab
        }
        from = std::max(from, a);
        to = std::min(to, b);
    }
    return from <= to + kSlack * std::abs(to) ? from : std::numeric_limits<double>::infinity();
}

/// Prefers the lowest face number among equals, as a linear search would.
bool isBetter(const std::optional<SurfaceHit>& best, int piece, int face, double distance) {
    return !best || distance < best->distance ||
           (distance == best->distance && best->piece == piece && face < best->face);
}

/// Barycentric weights, and the distance along a ray.
struct Meeting {
    Eigen::Vector3d barycentric;
    double distance;
};

/// Uses the three volumes that the ray spans with the triangle's edges.
std::optional<Meeting> meet(const Ray& ray, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                            const Eigen::Vector3d& c) {
    const Eigen::Vector3d pa = a - ray.origin, pb = b - ray.origin, pc = c - ray.origin;
    const double u = ray.direction.dot(pc.cross(pb));
    const double v = ray.direction.dot(pa.cross(pc));
    const double w = ray.direction.dot(pb.cross(pa));
    const bool allLeft = u >= 0 && v >= 0 && w >= 0, allRight = u <= 0 && v <= 0 && w <= 0;
    const double sum = u + v + w;
    if (!(allLeft || allRight) || sum == 0) {
        return std::nullopt;
    }
    const Eigen::Vector3d weights = Eigen::Vector3d(u, v, w) / sum;
    const double distance =
        (weights[0] * pa + weights[1] * pb + weights[2] * pc).dot(ray.direction);
    return distance > 0 ? std::optional(Meeting{weights, distance}) : std::nullopt;
}

/// Barycentric weights of a point inside a triangle of either orientation.
std::optional<Eigen::Vector3d> weightsAt(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                                         const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const double u = geometry::cross(c - b, p - b), v = geometry::cross(a - c, p - c),
                 w = geometry::cross(b - a, p - a);
    const bool covered = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    const double sum = u + v + w;
    return covered && sum != 0 ? std::optional<Eigen::Vector3d>(Eigen::Vector3d(u, v, w) / sum)
                               : std::nullopt;
}

/// A place on a segment as a share of it, and its distance from the ray.
struct Beside {
    double share = 0, distance = 0;
};

/// Distance of a segment from a ray per mm of depth; infinite if out of range.
Beside besides(const Ray& ray, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
               double farthest) {
    const Eigen::Vector3d edge = b - a, from = a - ray.origin;
    // Find the point nearest to the ray's line: projected along the ray, this is the distance of a
    // point from a segment in the plane.
    const Eigen::Vector3d edgeAcross = edge - edge.dot(ray.direction) * ray.direction;
    const Eigen::Vector3d fromAcross = from - from.dot(ray.direction) * ray.direction;
    const double t = geometry::nearestShare<Eigen::Vector3d>(Eigen::Vector3d::Zero(), fromAcross,
                                                             fromAcross + edgeAcross);
    const double depth = (from + t * edge).dot(ray.direction);
    return {t, depth > 0 && depth <= farthest ? (fromAcross + t * edgeAcross).norm() / depth
                                              : std::numeric_limits<double>::infinity()};
}

/// False if no point of the box can be inside the cone around the ray.
bool mayMeet(const Ray& ray, double slope, const Eigen::AlignedBox3d& box) {
    const Eigen::Vector3d middle = box.center() - ray.origin;
    const double radius = 0.5 * box.diagonal().norm(), depth = middle.dot(ray.direction);
    return (middle - depth * ray.direction).norm() <=
           radius + slope * std::max(0.0, depth + radius);
}

double wornLength(const Scene& scene, std::uint32_t first, std::uint32_t last) {
    double length = 0;
    for (std::uint32_t i = first + 1; i <= last; ++i) {
        length += (wornPoint(scene.lineVertices[i]) - wornPoint(scene.lineVertices[i - 1])).norm();
    }
    return length;
}

/// Sets how far along its side a hit is. @param share  of the segment
void measureAlong(const Scene& scene, const VertexRun& run, double share, SeamHit& hit) {
    const std::uint32_t from = run.first + static_cast<std::uint32_t>(hit.segment);
    const double whole = wornLength(scene, run.first, run.first + run.count - 1);
    const double before = wornLength(scene, run.first, from);
    const double within = share * wornLength(scene, from, from + 1);
    hit.along = whole > 0 ? std::clamp((before + within) / whole, 0.0, 1.0) : 0.0;
}

/// Interpolates a point of a face from its corners.
template <class Point, class PointOf>
Point pointOnFace(const Scene& scene, int piece, int face, const Eigen::Vector3d& weights,
                  const PointOf& pointOf) {
    const std::size_t first = scene.pieces[static_cast<std::size_t>(piece)].garmentRun.first;
    const std::uint32_t* corner =
        &scene.garment.triangles[3 * (first + static_cast<std::size_t>(face))];
    return weights[0] * pointOf(scene.vertices[corner[0]]) +
           weights[1] * pointOf(scene.vertices[corner[1]]) +
           weights[2] * pointOf(scene.vertices[corner[2]]);
}

}  // namespace

std::optional<SurfaceHit> pickGarment(const Scene& scene, const Ray& ray,
                                      const SheetPlaces& places) {
    std::optional<SurfaceHit> nearest;
    const auto farthest = [&nearest] {
        return nearest ? nearest->distance : std::numeric_limits<double>::max();
    };
    const auto& triangles = scene.garment.triangles;
    for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
        const PieceScene& piece = scene.pieces[i];
        if (piece.box.isEmpty() || placeOf(places, static_cast<int>(i)).hidden) {
            continue;
        }
        const auto tryFace = [&](std::uint32_t face) {
            const std::size_t t = piece.garmentRun.first + std::size_t{face};
            const auto meeting = meet(ray, wornPoint(scene.vertices[triangles[3 * t]]),
                                      wornPoint(scene.vertices[triangles[3 * t + 1]]),
                                      wornPoint(scene.vertices[triangles[3 * t + 2]]));
            if (meeting &&
                isBetter(nearest, static_cast<int>(i), static_cast<int>(face), meeting->distance)) {
                nearest = {static_cast<int>(i), static_cast<int>(face), meeting->barycentric,
                           meeting->distance};
            }
        };
        piece.garmentTree.search([&](const auto& box) { return distanceTo(ray, box, farthest()); },
                                 tryFace);
    }
    return nearest;
}

std::optional<SurfaceHit> pickPiece(const Scene& scene, int index, const Eigen::Vector2d& point) {
    const PieceScene& piece = scene.pieces[static_cast<std::size_t>(index)];
    if (!piece.flat || !piece.flatBox.contains(point)) {
        return std::nullopt;
    }
    const auto& triangles = scene.pattern.triangles;
    std::optional<SurfaceHit> first;
    piece.patternTree.search(
        [&point](const auto& box) {
            const bool within = point.x() >= static_cast<double>(box.low[0]) &&
                                point.x() <= static_cast<double>(box.high[0]) &&
                                point.y() >= static_cast<double>(box.low[1]) &&
                                point.y() <= static_cast<double>(box.high[1]);
            return within ? 0.0 : std::numeric_limits<double>::infinity();
        },
        [&](std::uint32_t face) {
            const std::size_t t = 3 * (piece.patternRun.first + std::size_t{face});
            const auto corner = [&](std::size_t k) -> Eigen::Vector2d {
                return flatPoint(scene.vertices[triangles[t + k]]);
            };
            const auto weights = weightsAt(point, corner(0), corner(1), corner(2));
            if (weights && isBetter(first, index, static_cast<int>(face), 0)) {
                first = {index, static_cast<int>(face), *weights, 0};
            }
        });
    return first;
}

std::optional<SurfaceHit> pickPattern(const Scene& scene, const SheetPlaces& places,
                                      const Eigen::Vector2d& point) {
    for (int i = static_cast<int>(scene.pieces.size()); i-- > 0;) {
        const SheetPlace& place = placeOf(places, i);
        if (place.hidden) {
            continue;
        }
        if (auto hit = pickPiece(scene, i, place.placement.undone(point))) {
            return hit;
        }
    }
    return std::nullopt;
}

Eigen::Vector3d garmentPoint(const Scene& scene, int piece, int face,
                             const Eigen::Vector3d& barycentric) {
    return pointOnFace<Eigen::Vector3d>(scene, piece, face, barycentric, wornPoint<ClothVertex>);
}

Eigen::Vector2d patternPoint(const Scene& scene, int piece, int face,
                             const Eigen::Vector3d& barycentric) {
    return pointOnFace<Eigen::Vector2d>(scene, piece, face, barycentric, flatPoint<ClothVertex>);
}

std::optional<SeamHit> pickPatternSeam(const Scene& scene, const SheetPlaces& places,
                                       const Eigen::Vector2d& at, double radius,
                                       const SeamFilter& counts) {
    std::optional<SeamHit> nearest;
    double share = 0;
    const auto& lines = scene.patternLines;
    for (std::size_t s = 0; s < lines.seams.size(); ++s) {
        if (counts && !counts(static_cast<int>(s))) {
            continue;
        }
        for (int side = 0; side < 2; ++side) {
            const VertexRun run = lines.seams[s][static_cast<std::size_t>(side)];
            const SeamScene::Side& part = scene.seams[s].sides[static_cast<std::size_t>(side)];
            if (run.count < 2 || placeOf(places, part.piece).hidden) {
                continue;
            }
            const Eigen::Vector2d local = placeOf(places, part.piece).placement.undone(at);
            if (part.flatBox.exteriorDistance(local) > radius) {
                continue;
            }
            for (std::uint32_t i = run.first + 1; i < run.first + run.count; ++i) {
                const Eigen::Vector2d a = flatPoint(scene.lineVertices[i - 1]),
                                      b = flatPoint(scene.lineVertices[i]);
                const double distance = geometry::distanceToSegment(local, a, b);
                if (distance <= radius && (!nearest || distance < nearest->distance)) {
                    nearest = {static_cast<int>(s), side, static_cast<int>(i - run.first) - 1,
                               distance};
                    share = geometry::nearestShare<Eigen::Vector2d>(local, a, b);
                }
            }
        }
    }
    if (nearest) {
        const auto& sides = lines.seams[static_cast<std::size_t>(nearest->seam)];
        measureAlong(scene, sides[static_cast<std::size_t>(nearest->side)], share, *nearest);
    }
    return nearest;
}

std::optional<SeamHit> pickGarmentSeam(const Scene& scene, const Ray& ray, double slope,
                                       double farthest, const SeamFilter& counts,
                                       const SheetPlaces& places) {
    std::optional<SeamHit> nearest;
    double share = 0;
    const auto& lines = scene.garmentLines;
    for (std::size_t s = 0; s < lines.seams.size(); ++s) {
        if ((counts && !counts(static_cast<int>(s))) || scene.seams[s].box.isEmpty() ||
            !mayMeet(ray, slope, scene.seams[s].box)) {
            continue;
        }
        for (int side = 0; side < 2; ++side) {
            const VertexRun run = lines.seams[s][static_cast<std::size_t>(side)];
            if (placeOf(places, scene.seams[s].sides[static_cast<std::size_t>(side)].piece)
                    .hidden) {
                continue;
            }
            for (std::uint32_t i = run.first + 1; i < run.first + run.count; ++i) {
                const Beside there = besides(ray, wornPoint(scene.lineVertices[i - 1]),
                                             wornPoint(scene.lineVertices[i]), farthest);
                if (there.distance <= slope && (!nearest || there.distance < nearest->distance)) {
                    nearest = {static_cast<int>(s), side, static_cast<int>(i - run.first) - 1,
                               there.distance};
                    share = there.share;
                }
            }
        }
    }
    if (nearest) {
        const auto& sides = lines.seams[static_cast<std::size_t>(nearest->seam)];
        measureAlong(scene, sides[static_cast<std::size_t>(nearest->side)], share, *nearest);
    }
    return nearest;
}

LineVertex pointAlong(const Scene& scene, const VertexRun& line, double along) {
    const std::uint32_t last = line.first + line.count - 1;
    double left = std::clamp(along, 0.0, 1.0) * wornLength(scene, line.first, last);
    std::uint32_t i = line.first;
    while (i + 1 < last && wornLength(scene, i, i + 1) < left) {
        left -= wornLength(scene, i, i + 1);
        ++i;
    }
    LineVertex point = scene.lineVertices[i];
    if (i == last) {
        return point;
    }
    const LineVertex& next = scene.lineVertices[i + 1];
    const double length = wornLength(scene, i, i + 1);
    const auto t = static_cast<float>(length > 0 ? std::min(1.0, left / length) : 0.0);
    const auto goOn = [t](float from, float to) -> float { return from + t * (to - from); };
    for (std::size_t k = 0; k < 3; ++k) {
        point.position[k] = goOn(point.position[k], next.position[k]);
    }
    for (std::size_t k = 0; k < 2; ++k) {
        point.flat[k] = goOn(point.flat[k], next.flat[k]);
    }
    return point;
}

}  // namespace toile::app
