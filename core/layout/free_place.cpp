// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layout/free_place.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "core/geometry/segment.h"

namespace toile {
namespace {

using Box = Eigen::AlignedBox2d;
using Vector2 = Eigen::Vector2d;

constexpr int kDirections = 32;
constexpr int kBisections = 8;
/// Largest change of an outline by thinning, as a fraction of the gap.
constexpr double kThinning = 0.1;
/// Largest number of points after thinning: a frayed edge must not cost more than a smooth one.
constexpr std::size_t kMaxPoints = 400;

/// Keeps the points between `from` and `to` that are far from the line through the kept points
/// (Douglas and Peucker).
void thin(const std::vector<Vector2>& points, std::size_t from, std::size_t to, double most,
          std::vector<char>& kept) {
    std::vector<std::pair<std::size_t, std::size_t>> open{{from, to}};
    while (!open.empty()) {
        const auto [a, b] = open.back();
        open.pop_back();
        double farthest = most;
        std::size_t at = 0;
        for (std::size_t i = a + 1; i < b; ++i) {
            const double d =
                geometry::distanceToSegment(points[i], points[a], points[b % points.size()]);
            if (d > farthest) {
                farthest = d;
                at = i;
            }
        }
        if (at > 0) {
            kept[at] = 1;
            open.emplace_back(a, at);
            open.emplace_back(at, b);
        }
    }
}

struct Shape {
    std::vector<Vector2> points;
    Box box;
};

Shape shapeOf(const Points2& outline, double most) {
    Shape shape;
    if (outline.rows() < 3 || !outline.allFinite()) {
        return shape;
    }
    std::vector<Vector2> all;
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        all.emplace_back(outline.row(i).transpose());
    }
    const auto farthest = static_cast<std::size_t>(
        std::ranges::max_element(
            all, {}, [&](const Vector2& p) -> double { return (p - all.front()).squaredNorm(); }) -
        all.begin());
    std::vector<char> kept(all.size(), 0);
    for (std::size_t count = kMaxPoints + 1; count > kMaxPoints; most *= 2) {
        std::ranges::fill(kept, 0);
        kept[0] = kept[farthest] = 1;
        thin(all, 0, farthest, most, kept);
        thin(all, farthest, all.size(), most, kept);
        count = static_cast<std::size_t>(std::ranges::count(kept, 1));
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (kept[i]) {
            shape.points.push_back(all[i]);
            shape.box.extend(all[i]);
        }
    }
    return shape;
}

bool segmentsCross(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d) {
    return (geometry::cross(b - a, c - a) > 0) != (geometry::cross(b - a, d - a) > 0) &&
           (geometry::cross(d - c, a - c) > 0) != (geometry::cross(d - c, b - c) > 0);
}

bool contains(const Shape& shape, const Vector2& p) {
    bool inside = false;
    for (std::size_t i = 0, k = shape.points.size() - 1; i < shape.points.size(); k = i++) {
        const Vector2 &a = shape.points[i], &b = shape.points[k];
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) {
            inside = !inside;
        }
    }
    return inside;
}

Box grown(Box box, double by) {
    box.min().array() -= by;
    box.max().array() += by;
    return box;
}

/// True if the shape, moved, overlaps the other or comes closer to it than `gap`.
bool inTheWay(const Shape& moving, const Vector2& move, const Shape& other, double gap) {
    Box box = moving.box;
    box.translate(move);
    if (!grown(box, gap).intersects(other.box)) {
        return false;
    }
    if (contains(other, moving.points.front() + move) ||
        contains(moving, other.points.front() - move)) {
        return true;
    }
    // Only edges near both boxes can be near each other.
    const Box near = grown(box.intersection(grown(other.box, gap)), gap);
    std::vector<std::pair<Vector2, Vector2>> edges;
    for (std::size_t i = 0, k = other.points.size() - 1; i < other.points.size(); k = i++) {
        Box edge(other.points[i]);
        edge.extend(other.points[k]);
        if (edge.intersects(near)) {
            edges.emplace_back(other.points[k], other.points[i]);
        }
    }
    for (std::size_t i = 0, k = moving.points.size() - 1; i < moving.points.size(); k = i++) {
        const Vector2 a = moving.points[k] + move, b = moving.points[i] + move;
        Box edge(a);
        edge.extend(b);
        if (!edge.intersects(near)) {
            continue;
        }
        const Box nearby = grown(edge, gap);
        for (const auto& [c, d] : edges) {
            Box there(c);
            there.extend(d);
            if (there.intersects(nearby) &&
                (geometry::distanceToSegment(a, c, d) < gap ||
                 geometry::distanceToSegment(b, c, d) < gap ||
                 geometry::distanceToSegment(c, a, b) < gap ||
                 geometry::distanceToSegment(d, a, b) < gap || segmentsCross(a, b, c, d))) {
                return true;
            }
        }
    }
    return false;
}

/// How far the shape must move along a direction to pass the other completely.
double wayPast(const Shape& moving, const Shape& other, const Vector2& along, double gap) {
    double first = std::numeric_limits<double>::infinity(), last = -first;
    for (const Vector2& p : moving.points) {
        first = std::min(first, p.dot(along));
    }
    for (const Vector2& p : other.points) {
        last = std::max(last, p.dot(along));
    }
    return last - first + 1.001 * gap;
}

class Search {
public:
    Search(const Points2& outline, const std::vector<Points2>& others, double gap)
        : gap_((1 + 2 * kThinning) * gap), moving_(shapeOf(outline, kThinning * gap)) {
        for (const Points2& other : others) {
            if (Shape shape = shapeOf(other, kThinning * gap); !shape.points.empty()) {
                others_.push_back(std::move(shape));
            }
        }
    }

    Vector2 shortest() const {
        Vector2 best = Vector2::Zero();
        if (moving_.points.empty() || !firstInTheWay(best)) {
            return best;
        }
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k < kDirections; ++k) {
            const double angle = 2 * std::numbers::pi * k / kDirections;
            const Vector2 along(std::cos(angle), std::sin(angle));
            const double way = wayAlong(along, least);
            // Of moves equal up to rounding take the first, so that all machines agree.
            if (way < (1 - 1e-6) * least) {
                least = way;
                best = way * along;
            }
        }
        return best;
    }

private:
    const Shape* firstInTheWay(const Vector2& move) const {
        const auto found = std::ranges::find_if(
            others_, [&](const Shape& other) { return inTheWay(moving_, move, other, gap_); });
        return found == others_.end() ? nullptr : &*found;
    }

    /// The length of a free move; any value of at least `least` if it is not shorter than that.
    double wayAlong(const Vector2& along, double least) const {
        double blocked = 0, free = 0;
        // Passes one shape after the other, and none of them twice.
        const Shape* other = firstInTheWay(Vector2::Zero());
        for (std::size_t round = 0; other && round < others_.size(); ++round) {
            free = std::max(free, wayPast(moving_, *other, along, gap_));
            other = firstInTheWay(free * along);
        }
        if (free > least) {
            if (firstInTheWay(least * along)) {
                return free;
            }
            free = least;
        }
        for (int round = 0; round < kBisections; ++round) {
            const double middle = 0.5 * (blocked + free);
            (firstInTheWay(middle * along) ? blocked : free) = middle;
        }
        return free;
    }

    double gap_;
    Shape moving_;
    std::vector<Shape> others_;
};

}  // namespace

Eigen::Vector2d moveToFreePlace(const Points2& outline, const std::vector<Points2>& others,
                                double gap) {
    return Search(outline, others, gap).shortest();
}

}  // namespace toile
