// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layout/sheet_overlaps.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

}  // namespace toile
