// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/picking.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile {

namespace {

Eigen::Vector3d position(const Scene& scene, std::uint32_t index) {
    return Eigen::Map<const Eigen::Vector3f>(scene.garment.vertices[index].position).cast<double>();
}

Eigen::Vector2d flatPoint(const Scene& scene, std::uint32_t index) {
    return Eigen::Map<const Eigen::Vector2f>(scene.pattern.vertices[index].flat).cast<double>();
}

/// Slab test: does the half-line meet the box?
bool meets(const Ray& ray, const Eigen::AlignedBox3d& box) {
    double from = 0, to = std::numeric_limits<double>::max();
    for (int k = 0; k < 3; ++k) {
        const double inverse = 1.0 / ray.direction[k];  // infinite where parallel: still right
        double a = (box.min()[k] - ray.origin[k]) * inverse;
        double b = (box.max()[k] - ray.origin[k]) * inverse;
        if (std::isnan(a) || std::isnan(b)) {
            continue;  // parallel and within the slab's plane
        }
        if (a > b) {
            std::swap(a, b);
        }
        from = std::max(from, a);
        to = std::min(to, b);
    }
    return from <= to;
}

/// Distance to a triangle, by the three volumes the ray spans with its edges.
std::optional<double> distanceTo(const Ray& ray, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
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
    const double distance = ((u * pa + v * pb + w * pc) / sum).dot(ray.direction);
    return distance > 0 ? std::optional(distance) : std::nullopt;
}

bool covers(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
            const Eigen::Vector2d& c) {
    const auto side = [&p](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
        return (to.x() - from.x()) * (p.y() - from.y()) - (to.y() - from.y()) * (p.x() - from.x());
    };
    const double u = side(a, b), v = side(b, c), w = side(c, a);
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

}  // namespace

std::optional<GarmentHit> pickGarment(const Scene& scene, const Ray& ray) {
    std::optional<GarmentHit> nearest;
    const auto& triangles = scene.garment.triangles;
    for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
        const PieceScene& piece = scene.pieces[i];
        if (piece.box.isEmpty() || !meets(ray, piece.box)) {
            continue;
        }
        const std::size_t end = piece.garmentRun.first + piece.garmentRun.count;
        for (std::size_t t = piece.garmentRun.first; t < end; ++t) {
            const auto distance = distanceTo(ray, position(scene, triangles[3 * t]),
                                             position(scene, triangles[3 * t + 1]),
                                             position(scene, triangles[3 * t + 2]));
            if (distance && (!nearest || *distance < nearest->distance)) {
                nearest = GarmentHit{static_cast<int>(i), *distance};
            }
        }
    }
    return nearest;
}

std::optional<int> pickPattern(const Scene& scene, const Eigen::Vector2d& point) {
    const auto& triangles = scene.pattern.triangles;
    for (std::size_t i = scene.pieces.size(); i-- > 0;) {
        const PieceScene& piece = scene.pieces[i];
        if (!piece.flat || !piece.placedBox().contains(point)) {
            continue;
        }
        const Eigen::Vector2d local = point - piece.offset;
        const std::size_t end = piece.patternRun.first + piece.patternRun.count;
        for (std::size_t t = piece.patternRun.first; t < end; ++t) {
            if (covers(local, flatPoint(scene, triangles[3 * t]),
                       flatPoint(scene, triangles[3 * t + 1]),
                       flatPoint(scene, triangles[3 * t + 2]))) {
                return static_cast<int>(i);
            }
        }
    }
    return std::nullopt;
}

}  // namespace toile
