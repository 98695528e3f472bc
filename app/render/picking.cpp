// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/picking.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/segment.h"

namespace toile {

namespace {

/// Slab test: how far along the half-line the box begins, a little less rather than more (a flat
/// piece of cloth has a box without any depth); infinite where it is missed or beyond `farthest`.
double distanceTo(const Ray& ray, const TriangleTree<3>::Box& box, double farthest) {
    constexpr double kSlack = 1e-9;
    double from = 0, to = farthest;
    for (int k = 0; k < 3; ++k) {
        const double inverse = 1.0 / ray.direction[k];  // infinite where parallel: still right
        const auto at = static_cast<std::size_t>(k);
        double a = (static_cast<double>(box.low[at]) - ray.origin[k]) * inverse;
        double b = (static_cast<double>(box.high[at]) - ray.origin[k]) * inverse;
        if (std::isnan(a) || std::isnan(b)) {
            continue;  // parallel and within the slab's plane
        }
        if (a > b) {
            std::swap(a, b);
        }
        from = std::max(from, a - kSlack * std::abs(a));
        to = std::min(to, b + kSlack * std::abs(b));
    }
    return from <= to ? from : std::numeric_limits<double>::infinity();
}

/// The face of lowest number among those found, as a search one by one would find it.
bool isBetter(const std::optional<SurfaceHit>& best, int piece, int face, double distance) {
    return !best || distance < best->distance ||
           (distance == best->distance && best->piece == piece && face < best->face);
}

/// Weights of a triangle's corners, and the distance to it along a ray.
struct Meeting {
    Eigen::Vector3d barycentric;
    double distance;
};

/// By the three volumes the ray spans with the triangle's edges.
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

/// Weights of a triangle's corners at a point in it, whichever way the triangle is turned.
std::optional<Eigen::Vector3d> weightsAt(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                                         const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const double u = cross(c - b, p - b), v = cross(a - c, p - c), w = cross(b - a, p - a);
    const bool covered = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    const double sum = u + v + w;
    return covered && sum != 0 ? std::optional<Eigen::Vector3d>(Eigen::Vector3d(u, v, w) / sum)
                               : std::nullopt;
}

}  // namespace

std::optional<SurfaceHit> pickGarment(const Scene& scene, const Ray& ray) {
    std::optional<SurfaceHit> nearest;
    const auto farthest = [&nearest] {
        return nearest ? nearest->distance : std::numeric_limits<double>::max();
    };
    const auto& triangles = scene.garment.triangles;
    for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
        const PieceScene& piece = scene.pieces[i];
        if (piece.box.isEmpty()) {
            continue;
        }
        const auto tryFace = [&](std::uint32_t face) {
            const std::size_t t = piece.garmentRun.first + std::size_t{face};
            const auto meeting = meet(ray, wornPoint(scene.garment.vertices[triangles[3 * t]]),
                                      wornPoint(scene.garment.vertices[triangles[3 * t + 1]]),
                                      wornPoint(scene.garment.vertices[triangles[3 * t + 2]]));
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
                return flatPoint(scene.pattern.vertices[triangles[t + k]]);
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
        if (auto hit = pickPiece(scene, i, placeOf(places, i).placement.undone(point))) {
            return hit;
        }
    }
    return std::nullopt;
}

Eigen::Vector3d garmentPoint(const Scene& scene, int piece, int face,
                             const Eigen::Vector3d& barycentric) {
    const std::size_t first = scene.pieces[static_cast<std::size_t>(piece)].garmentRun.first;
    const std::uint32_t* corner =
        &scene.garment.triangles[3 * (first + static_cast<std::size_t>(face))];
    return barycentric[0] * wornPoint(scene.garment.vertices[corner[0]]) +
           barycentric[1] * wornPoint(scene.garment.vertices[corner[1]]) +
           barycentric[2] * wornPoint(scene.garment.vertices[corner[2]]);
}

Eigen::Vector2d patternPoint(const Scene& scene, int piece, int face,
                             const Eigen::Vector3d& barycentric) {
    const std::size_t first = scene.pieces[static_cast<std::size_t>(piece)].patternRun.first;
    const std::uint32_t* corner =
        &scene.pattern.triangles[3 * (first + static_cast<std::size_t>(face))];
    return barycentric[0] * flatPoint(scene.pattern.vertices[corner[0]]) +
           barycentric[1] * flatPoint(scene.pattern.vertices[corner[1]]) +
           barycentric[2] * flatPoint(scene.pattern.vertices[corner[2]]);
}

}  // namespace toile
