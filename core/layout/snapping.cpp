// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layout/snapping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/base/units.h"
#include "core/geometry/segment.h"

namespace toile {
namespace {

constexpr double kStraight = kDegree;         // largest turn of a straight stretch
constexpr double kCorner = 15 * kDegree;      // smallest turn of a corner
constexpr double kShareOfOutline = 1 / 20.0;  // smallest length of a straight stretch

/// The nearest target so far along one direction.
struct Nearest {
    double shift = 0;
    double distance;

    bool offer(double candidate) {
        if (std::abs(candidate) >= distance) {
            return false;
        }
        shift = candidate;
        distance = std::abs(candidate);
        return true;
    }
};

std::array<double, 3> stops(const Eigen::AlignedBox2d& box, int axis) {
    return {box.min()[axis], box.max()[axis], box.center()[axis]};
}

/// Snaps one direction of the moved box.
Nearest snapAxis(const Eigen::AlignedBox2d& box, int axis, const SnapTargets& targets,
                 double radius, std::vector<SnapLine>& lines) {
    Nearest nearest{0, radius};
    double at = 0;
    const Eigen::AlignedBox2d* partner = nullptr;
    for (const Eigen::AlignedBox2d& other : targets.boxes) {
        for (const double target : stops(other, axis)) {
            for (const double own : stops(box, axis)) {
                if (nearest.offer(target - own)) {
                    at = target;
                    partner = &other;
                }
            }
        }
    }
    if (partner) {
        const int along = 1 - axis;
        SnapLine line;
        line.from[axis] = line.to[axis] = at;
        line.from[along] = std::min(box.min()[along], partner->min()[along]);
        line.to[along] = std::max(box.max()[along], partner->max()[along]);
        lines.push_back(line);
    } else if (targets.gridStep > 0) {
        for (const double own : {box.min()[axis], box.max()[axis]}) {
            nearest.offer(std::round(own / targets.gridStep) * targets.gridStep - own);
        }
    }
    return nearest;
}

/// The shortest path from a moved vertex to a fixed one.
std::optional<std::pair<Eigen::Vector2d, Eigen::Vector2d>> nearestVertex(const Points2& moved,
                                                                         const Points2& staying,
                                                                         double radius) {
    std::vector<Eigen::Index> order(static_cast<std::size_t>(staying.rows()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    std::ranges::sort(order, {}, [&](Eigen::Index i) { return staying(i, 0); });
    std::optional<std::pair<Eigen::Vector2d, Eigen::Vector2d>> best;
    double least = radius;
    for (Eigen::Index i = 0; i < moved.rows(); ++i) {
        const double x = moved(i, 0);
        auto next = std::ranges::lower_bound(order, x - least, {},
                                             [&](Eigen::Index k) { return staying(k, 0); });
        for (; next != order.end() && staying(*next, 0) <= x + least; ++next) {
            const Eigen::Vector2d way = (staying.row(*next) - moved.row(i)).transpose();
            if (way.norm() < least) {
                least = way.norm();
                best.emplace(way, staying.row(*next).transpose());
            }
        }
    }
    return best;
}

}  // namespace

SnappedMove snappedMove(const Eigen::AlignedBox2d& box, const Points2& vertices,
                        const Eigen::Vector2d& way, const SnapTargets& targets, double radius) {
    SnappedMove snapped{way};
    if (box.isEmpty() || !(radius > 0) || !way.allFinite()) {
        return snapped;
    }
    Points2 moved = vertices;
    moved.rowwise() += way.transpose();
    if (const auto vertex = nearestVertex(moved, targets.vertices, radius)) {
        snapped.way += vertex->first;
        snapped.vertex = vertex->second;
        return snapped;
    }
    Eigen::AlignedBox2d place(box.min() + way, box.max() + way);
    for (const int axis : {0, 1}) {
        const double shift = snapAxis(place, axis, targets, radius, snapped.lines).shift;
        snapped.way[axis] += shift;
    }
    // Extend a line from one box to the other after both directions have snapped.
    for (SnapLine& line : snapped.lines) {
        const int along = line.from.x() == line.to.x() ? 1 : 0;
        const Eigen::Vector2d low = box.min() + snapped.way, high = box.max() + snapped.way;
        line.from[along] = std::min(line.from[along], low[along]);
        line.to[along] = std::max(line.to[along], high[along]);
    }
    return snapped;
}

std::vector<double> straightDirections(const Points2& outline) {
    struct Run {
        Eigen::Vector2d way = Eigen::Vector2d::Zero();
        double length = 0;
    };
    const Eigen::Index count = outline.rows();
    std::vector<Run> runs;
    double whole = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
        const Eigen::Vector2d edge = (outline.row((i + 1) % count) - outline.row(i)).transpose();
        const double length = edge.norm();
        if (!(length > 0) || !std::isfinite(length)) {
            continue;
        }
        whole += length;
        if (!runs.empty()) {
            const Eigen::Vector2d& way = runs.back().way;
            const double turned =
                std::atan2(way.x() * edge.y() - way.y() * edge.x(), way.dot(edge));
            if (std::abs(turned) <= kStraight) {
                runs.back().way += edge;
                runs.back().length += length;
                continue;
            }
        }
        runs.push_back({edge, length});
    }
    std::erase_if(runs, [&](const Run& run) { return run.length < kShareOfOutline * whole; });
    std::ranges::stable_sort(runs, std::greater<>(), &Run::length);
    std::vector<double> directions;
    for (const Run& run : runs) {
        const double angle = std::atan2(run.way.y(), run.way.x());
        directions.push_back(angle < 0 ? angle + kPi : angle >= kPi ? angle - kPi : angle);
    }
    return directions;
}

Points2 snapPoints(const Points2& outline) {
    const Eigen::Index count = outline.rows();
    std::vector<Eigen::Index> corners;
    for (Eigen::Index i = 0; i < count; ++i) {
        const Eigen::Vector2d in =
            (outline.row(i) - outline.row((i + count - 1) % count)).transpose();
        const Eigen::Vector2d out = (outline.row((i + 1) % count) - outline.row(i)).transpose();
        if (std::abs(std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out))) > kCorner) {
            corners.push_back(i);
        }
    }
    return outline(corners, Eigen::all);
}

std::optional<double> nearestEdgeDirection(const Points2& outline, const Eigen::Vector2d& point) {
    const Eigen::Index count = outline.rows();
    std::optional<double> direction;
    double least = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
        const Eigen::Vector2d from = outline.row(i).transpose();
        const Eigen::Vector2d to = outline.row((i + 1) % count).transpose();
        const Eigen::Vector2d edge = to - from;
        if (!(edge.squaredNorm() > 0)) {
            continue;
        }
        const double distance = geometry::distanceToSegment(point, from, to);
        if (!direction || distance < least) {
            least = distance;
            const double angle = std::atan2(edge.y(), edge.x());
            direction = angle < 0 ? angle + kPi : angle >= kPi ? angle - kPi : angle;
        }
    }
    return direction;
}

double snappedAngle(double angle, double step, std::span<const double> others, double radius) {
    Nearest nearest{0, radius};
    if (step > 0) {
        nearest.offer(std::round(angle / step) * step - angle);
    }
    for (const double other : others) {
        nearest.offer(std::remainder(other - angle, kPi));
    }
    return angle + nearest.shift;
}

}  // namespace toile
