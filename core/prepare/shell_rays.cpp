// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/shell_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace toile::shell {
namespace {

/// Minimum cosine between triangles that face each other: 37 degrees, as cloth is thinner than its
/// folds are wide. A rounded rim has no opposite.
constexpr double kFacing = 0.8;
/// Triangles tested per ray: more coincide only in files made to do so.
constexpr long kMaxVisits = 2000;
/// Likewise once all rays together have tested as many as they may.
constexpr long kMinVisits = 100;

/// Where a ray enters a box; infinite if it misses it.
/// @param inverse  componentwise inverse of its direction
template <class Box>
double entry(const Box& box, const Eigen::Vector3d& origin, const Eigen::Vector3d& inverse,
             double farthest) {
    double from = 0, to = farthest;
    for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        // Not in order of size: an empty box begins behind its end, and is missed.
        const bool isForward = !std::signbit(inverse[k]);
        const double a = ((isForward ? box.low : box.high)[at] - origin[k]) * inverse[k];
        const double b = ((isForward ? box.high : box.low)[at] - origin[k]) * inverse[k];
        if (std::isnan(a) || std::isnan(b)) {
            continue;  // parallel and within the slab
        }
        from = std::max(from, a);
        to = std::min(to, b);
    }
    return from <= to + 1e-9 * std::abs(to) ? from : geometry::TriangleTree<3, double>::kMissed;
}

}  // namespace

Rays::Rays(const Surface& surface)
    : surface_(surface),
      tree_(surface.mesh.V.data(), 3,
            {reinterpret_cast<const std::uint32_t*>(surface.mesh.F.data()),
             static_cast<std::size_t>(surface.mesh.F.size())}),
      same_(1e-7 * std::sqrt(surface.area.sum())) {}

template <class OnMet>
long Rays::look(int triangle, const Eigen::Vector3d& direction, const double& farthest,
                long maxVisits, const OnMet& onMet) const {
    const MeshArrays& mesh = surface_.mesh;
    const auto corner = [&mesh](int t, int k) -> Eigen::Vector3d {
        return mesh.V.row(mesh.F(t, k));
    };
    const Eigen::Vector3d origin =
        (corner(triangle, 0) + corner(triangle, 1) + corner(triangle, 2)) / 3;
    const Eigen::Vector3d inverse = direction.cwiseInverse();
    long visits = 0;
    const auto distanceTo = [&](const auto& box) {
        return visits < maxVisits ? entry(box, origin, inverse, farthest)
                                  : geometry::TriangleTree<3, double>::kMissed;
    };
    tree_.search(distanceTo, [&](std::uint32_t index) {
        ++visits;
        const int other = static_cast<int>(index);
        if (other == triangle) {
            return;
        }
        // Compares the volumes that the ray spans with the edges.
        const Eigen::Vector3d a = corner(other, 0) - origin, b = corner(other, 1) - origin,
                              c = corner(other, 2) - origin;
        const double u = direction.dot(c.cross(b)), v = direction.dot(a.cross(c)),
                     w = direction.dot(b.cross(a));
        const double sum = u + v + w;
        const bool isInside = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
        if (!isInside || sum == 0) {
            return;
        }
        const double distance = direction.dot(u * a + v * b + w * c) / sum;
        if (distance > same_ && distance <= farthest) {
            onMet(other, distance);
        }
    });
    return visits;
}

Meeting Rays::nearest(int triangle, const Eigen::Vector3d& direction, double farthest) const {
    Meeting met;
    look(triangle, direction, farthest, kMaxVisits, [&](int other, double distance) {
        if (distance < farthest || other < met.triangle) {
            farthest = distance;
            met.triangle = other;
        }
    });
    met.way = farthest * direction;
    return met;
}

std::vector<Meeting> Rays::all(int triangle, const Eigen::Vector3d& direction, long& visits) const {
    std::vector<std::pair<double, int>> met;
    visits -= look(triangle, direction, std::numeric_limits<double>::max(),
                   std::clamp(visits, kMinVisits, kMaxVisits),
                   [&met](int other, double distance) { met.emplace_back(distance, other); });
    std::ranges::sort(met);
    std::vector<Meeting> meetings;
    meetings.reserve(met.size());
    for (const auto& [distance, other] : met) {
        meetings.push_back({other, distance * direction});
    }
    return meetings;
}

Meeting Rays::opposite(int triangle, Facing facing, double farthest) const {
    const Eigen::Vector3d normal = surface_.normal.row(triangle);
    if (normal.isZero()) {
        return {};
    }
    const auto turnedAs = [&](const Meeting& meeting, double sign) {
        return meeting.triangle >= 0 &&
               sign * normal.dot(surface_.normal.row(meeting.triangle)) >= kFacing;
    };
    if (facing != Facing::Alike) {
        const Meeting met = nearest(
            triangle, facing == Facing::Apart ? Eigen::Vector3d(-normal) : normal, farthest);
        return turnedAs(met, -1) ? met : Meeting{};
    }
    const Meeting behind = nearest(triangle, -normal, farthest);
    const Meeting before =
        nearest(triangle, normal, behind.triangle < 0 ? farthest : behind.way.norm());
    const Meeting& met = before.triangle < 0 ? behind : before;
    return turnedAs(met, 1) ? met : Meeting{};
}

}  // namespace toile::shell
