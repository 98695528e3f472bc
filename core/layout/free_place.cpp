// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layout/free_place.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "core/geometry/segment.h"
#include "core/geometry/segment_pairs.h"

namespace toile {
namespace {

using Box = Eigen::AlignedBox2d;
using PointRow = Eigen::RowVector2d;

/// Smaller overlaps are edges that touch, mm.
constexpr double kOverlapTolerance = 1e-3;

Box boxOf(const Points2& outline) {
    Box box;
    if (outline.rows() < 3 || !outline.allFinite()) {
        return box;
    }
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        box.extend(Eigen::Vector2d(outline.row(i).transpose()));
    }
    return box;
}

PointRow next(const Points2& outline, Eigen::Index i) {
    return outline.row((i + 1) % outline.rows());
}

void addEdgesIn(const Box& box, const Points2& outline, std::vector<geometry::Segment2>& segments) {
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        Box edge;
        edge.extend(Eigen::Vector2d(outline.row(i).transpose()));
        edge.extend(Eigen::Vector2d(next(outline, i).transpose()));
        if (edge.intersects(box)) {
            segments.push_back({outline.row(i), next(outline, i)});
        }
    }
}

double distanceToLine(const PointRow& p, const geometry::Segment2& line) {
    const PointRow along = line.b - line.a;
    const PointRow off = p - line.a;
    const double length = along.norm();
    return length > 0 ? std::abs(along.x() * off.y() - along.y() * off.x()) / length : 0;
}

/// True if the segments cross and no end is within tolerance of the other's line.
bool crossWell(const geometry::Segment2& s, const geometry::Segment2& t) {
    const bool crosses =
        geometry::exactOrientation(s.a, s.b, t.a) * geometry::exactOrientation(s.a, s.b, t.b) < 0 &&
        geometry::exactOrientation(t.a, t.b, s.a) * geometry::exactOrientation(t.a, t.b, s.b) < 0;
    return crosses &&
           std::min(distanceToLine(t.a, s), distanceToLine(t.b, s)) > kOverlapTolerance &&
           std::min(distanceToLine(s.a, t), distanceToLine(s.b, t)) > kOverlapTolerance;
}

/// By the winding number, for either direction of the outline.
bool contains(const Points2& outline, const PointRow& p) {
    int winding = 0;
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        const PointRow a = outline.row(i), b = next(outline, i);
        if (a.y() <= p.y() && b.y() > p.y()) {
            winding += geometry::exactOrientation(a, b, p) > 0;
        } else if (a.y() > p.y() && b.y() <= p.y()) {
            winding -= geometry::exactOrientation(a, b, p) < 0;
        }
    }
    return winding != 0;
}

double distanceTo(const Points2& outline, const PointRow& p) {
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        const PointRow a = outline.row(i), b = next(outline, i);
        least = std::min(least, geometry::distanceToSegment(p, a, b));
    }
    return least;
}

/// Whether some place just inside the edges of `inner` is well inside `outer` too: true if an
/// outline contains the other or they coincide.
bool hasPlaceIn(const Points2& outer, const Points2& inner, const Box& both) {
    // A few probes suffice: crossing edges were found before.
    constexpr Eigen::Index kProbes = 16;
    constexpr double kInside = 10 * kOverlapTolerance;
    const Eigen::Index step = std::max<Eigen::Index>(1, inner.rows() / kProbes);
    for (Eigen::Index i = 0; i < inner.rows(); i += step) {
        const PointRow a = inner.row(i), along = next(inner, i) - a;
        if (along.norm() < kInside) {
            continue;
        }
        const PointRow aside = kInside * PointRow(-along.y(), along.x()).normalized();
        for (const PointRow& p :
             {PointRow(a + along / 2 + aside), PointRow(a + along / 2 - aside)}) {
            if (both.contains(Eigen::Vector2d(p.transpose())) && contains(inner, p) &&
                contains(outer, p) && distanceTo(outer, p) > kOverlapTolerance) {
                return true;
            }
        }
    }
    return false;
}

bool overlap(const Points2& one, const Points2& other, const Box& both) {
    std::vector<geometry::Segment2> segments;
    addEdgesIn(both, one, segments);
    const auto split = static_cast<int>(segments.size());
    addEdgesIn(both, other, segments);
    bool found = false;
    geometry::visitSegmentPairs(segments, 0, [&](int i, int j, const geometry::PlaneCell&) -> bool {
        const bool ofBoth = i < split && j >= split;
        found = found || (ofBoth && crossWell(segments[static_cast<std::size_t>(i)],
                                              segments[static_cast<std::size_t>(j)]));
        return !found;
    });
    return found || hasPlaceIn(one, other, both) || hasPlaceIn(other, one, both);
}

}  // namespace

std::vector<std::pair<int, int>> overlappingOutlines(const std::vector<Points2>& outlines) {
    std::vector<Box> boxes;
    std::vector<int> order;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        boxes.push_back(boxOf(outlines[i]));
        if (!boxes.back().isEmpty()) {
            order.push_back(static_cast<int>(i));
        }
    }
    const auto box = [&boxes](int i) -> const Box& { return boxes[static_cast<std::size_t>(i)]; };
    std::ranges::stable_sort(
        order, [&](int a, int b) -> bool { return box(a).min().x() < box(b).min().x(); });
    std::vector<std::pair<int, int>> found;
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const int a = order[i], b = order[j];
            if (box(b).min().x() > box(a).max().x()) {
                break;
            }
            const Box both = box(a).intersection(box(b));
            const bool touch = both.isEmpty() || both.sizes().minCoeff() <= kOverlapTolerance;
            if (!touch && overlap(outlines[static_cast<std::size_t>(a)],
                                  outlines[static_cast<std::size_t>(b)], both)) {
                found.emplace_back(std::min(a, b), std::max(a, b));
            }
        }
    }
    std::ranges::sort(found);
    return found;
}

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
