// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/segment.h"
#include "core/nest/collision.h"

namespace toile::nest {
namespace {

using geometry::exactOrientation;
using geometry::Polygon;
using Point = Eigen::RowVector2d;

/// The wedge of an area at a point of its boundary: the inside is anti-clockwise from the direction
/// to `next` up to the direction to `last`.
struct Wedge {
    Point next, last;
};

/// Whether two points, known to be collinear with `from`, lie in the same direction from it.
bool isSameSide(const Point& from, const Point& a, const Point& b) {
    return a.x() != from.x() ? (a.x() > from.x()) == (b.x() > from.x()) && b.x() != from.x()
                             : (a.y() > from.y()) == (b.y() > from.y());
}

bool isSameWay(const Point& from, const Point& a, const Point& b) {
    return exactOrientation(from, a, b) == 0 && isSameSide(from, a, b);
}

/// Whether a direction from the point leads strictly into the wedge.
bool goesInto(const Point& from, const Point& to, const Wedge& wedge) {
    if (isSameWay(from, to, wedge.next) || isSameWay(from, to, wedge.last)) {
        return false;
    }
    const int turn = exactOrientation(from, wedge.next, wedge.last);
    const bool isAfterNext = exactOrientation(from, wedge.next, to) > 0;
    const bool isBeforeLast = exactOrientation(from, to, wedge.last) > 0;
    return turn > 0   ? isAfterNext && isBeforeLast
           : turn < 0 ? isAfterNext || isBeforeLast
                      : isAfterNext;
}

bool doWedgesMeet(const Point& at, const Wedge& a, const Wedge& b) {
    return goesInto(at, a.next, b) || goesInto(at, a.last, b) || goesInto(at, b.next, a) ||
           goesInto(at, b.last, a) || isSameWay(at, a.next, b.next) ||
           isSameWay(at, a.last, b.last);
}

struct Edge {
    Point before, from, to;
};

/// The edges that intersect a box.
std::vector<Edge> edgesIn(const Rings& rings, const Point& low, const Point& high) {
    std::vector<Edge> edges;
    for (const Polygon& ring : rings) {
        const Eigen::Index count = ring.rows();
        for (Eigen::Index k = 0; k < count; ++k) {
            const Point from = ring.row(k), to = ring.row((k + 1) % count);
            if ((from.cwiseMin(to).array() <= high.array()).all() &&
                (from.cwiseMax(to).array() >= low.array()).all()) {
                edges.push_back({ring.row((k + count - 1) % count), from, to});
            }
        }
    }
    return edges;
}

bool isInBox(const Point& p, const Edge& edge) {
    return (p.array() >= edge.from.cwiseMin(edge.to).array()).all() &&
           (p.array() <= edge.from.cwiseMax(edge.to).array()).all();
}

/// Whether the path through a point crosses from one side of another to its other side. If they
/// overlap along an edge, they only touch.
bool goesAcross(const Point& at, const Wedge& way, const Wedge& other) {
    const auto isAlong = [&](const Point& end) {
        return isSameWay(at, end, other.next) || isSameWay(at, end, other.last);
    };
    return !isAlong(way.next) && !isAlong(way.last) &&
           goesInto(at, way.next, other) != goesInto(at, way.last, other);
}

/// Tests two edges: they cross, or meet at the start point of one of them and the paths through it
/// satisfy the predicate. The end point of an edge is tested with the next edge.
/// @param says  predicate on the point and the wedges of `a` and `b` there
template <typename Says>
bool doEdgesMeet(const Edge& a, const Edge& b, Says says) {
    const int a0 = exactOrientation(b.from, b.to, a.from);
    const int a1 = exactOrientation(b.from, b.to, a.to);
    const int b0 = exactOrientation(a.from, a.to, b.from);
    const int b1 = exactOrientation(a.from, a.to, b.to);
    if (a0 * a1 < 0 && b0 * b1 < 0) {
        return true;
    }
    if (a.from == b.from) {
        return says(a.from, Wedge{a.to, a.before}, Wedge{b.to, b.before});
    }
    if (a0 == 0 && a.from != b.to && isInBox(a.from, b) &&
        says(a.from, Wedge{a.to, a.before}, Wedge{b.to, b.from})) {
        return true;
    }
    return b0 == 0 && b.from != a.to && isInBox(b.from, a) &&
           says(b.from, Wedge{b.to, b.before}, Wedge{a.to, a.from});
}

bool doBoxesMeet(const Edge& a, const Edge& b) {
    return (b.from.cwiseMin(b.to).array() <= a.from.cwiseMax(a.to).array()).all() &&
           (b.from.cwiseMax(b.to).array() >= a.from.cwiseMin(a.to).array()).all();
}

/// 1 inside, 0 on the rim, -1 outside.
int sideOf(const Point& p, const Rings& rings) {
    bool isIn = false;
    for (const Polygon& ring : rings) {
        for (Eigen::Index k = 0; k < ring.rows(); ++k) {
            const Point from = ring.row(k), to = ring.row((k + 1) % ring.rows());
            const int side = exactOrientation(from, to, p);
            if (side == 0 && isInBox(p, {from, from, to})) {
                return 0;
            }
            if ((from.y() > p.y()) != (to.y() > p.y())) {
                isIn = isIn != ((to.y() > from.y()) == (side > 0));
            }
        }
    }
    return isIn ? 1 : -1;
}

/// Whether a ring lies inside, if no edges cross.
bool isARingInside(const Rings& rings, const Rings& other) {
    return std::ranges::any_of(rings, [&other](const Polygon& ring) {
        for (Eigen::Index k = 0; k < ring.rows(); ++k) {
            if (const int side = sideOf(ring.row(k), other); side != 0) {
                return side > 0;
            }
        }
        return false;
    });
}

}  // namespace

bool doOverlap(const Rings& a, const Rings& b) {
    const Point low = a[0].colwise().minCoeff().cwiseMax(b[0].colwise().minCoeff());
    const Point high = a[0].colwise().maxCoeff().cwiseMin(b[0].colwise().maxCoeff());
    if ((low.array() >= high.array()).any()) {
        return false;
    }
    const auto edgesOfA = edgesIn(a, low, high), edgesOfB = edgesIn(b, low, high);
    for (const Edge& edge : edgesOfA) {
        for (const Edge& other : edgesOfB) {
            if (doBoxesMeet(edge, other) && doEdgesMeet(edge, other, doWedgesMeet)) {
                return true;
            }
        }
    }
    return isARingInside(a, b) || isARingInside(b, a);
}

bool doRingsCross(const Rings& rings) {
    const Point all = Point::Constant(HUGE_VAL);
    const auto edges = edgesIn(rings, -all, all);
    for (auto a = edges.begin(); a != edges.end(); ++a) {
        for (auto b = edges.begin(); b != a; ++b) {
            if (doBoxesMeet(*a, *b) && doEdgesMeet(*a, *b, goesAcross)) {
                return true;
            }
        }
    }
    return false;
}

Rings wound(Rings rings) {
    for (std::size_t k = 0; k < rings.size(); ++k) {
        Polygon turned = geometry::antiClockwise(rings[k]);
        rings[k] = k == 0 ? turned : Polygon(turned.colwise().reverse());
    }
    return rings;
}

}  // namespace toile::nest
