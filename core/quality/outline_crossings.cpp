// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/outline_crossings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/geometry/segment.h"
#include "core/geometry/segment_pairs.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// Distance from a line, relative to the outline's extent, below which a point lies on it.
constexpr double kTouching = 1e-12;
/// Up to this many edges, testing all other edges is faster than a search for near ones.
constexpr int kFewEdges = 100;

using Point = Eigen::RowVector2d;

class Outline {
public:
    Outline(const Points2& Q, const std::vector<int>& boundary)
        : n_(static_cast<int>(boundary.size())), segments_(boundary.size()) {
        Point low = Q.row(boundary.front());
        Point high = low;
        for (int i = 0; i < n_; ++i) {
            segments_[i] = {Q.row(boundary[i]), Q.row(boundary[(i + 1) % n_])};
            low = low.cwiseMin(segments_[i].a);
            high = high.cwiseMax(segments_[i].a);
        }
        touching_ = kTouching * (high - low).norm();
    }

    /// Crossings that involve an edge numbered `from` or above.
    std::vector<OutlineCrossing> crossings(int from, int limit) const {
        std::vector<OutlineCrossing> found;
        const auto look = [&](int i, int j, const geometry::PlaneCell& cell) {
            if (j < from || j - i == 1 || j - i == n_ - 1) {
                return true;
            }
            const auto place = crossing(i, j);
            if (place && cell.owns(*place)) {
                found.push_back({i, j, *place});
            }
            return static_cast<int>(found.size()) < limit;
        };
        if (n_ - from > kFewEdges) {
            geometry::visitSegmentPairs(segments_, touching_, look);
        } else {
            const geometry::PlaneCell plane;
            bool goesOn = true;
            for (int j = from; j < n_; ++j) {
                for (int i = 0; i < j && goesOn; ++i) {
                    goesOn = look(i, j, plane);
                }
            }
        }
        std::sort(found.begin(), found.end(), [](const auto& s, const auto& t) {
            return std::tie(s.first, s.second) < std::tie(t.first, t.second);
        });
        return found;
    }

private:
    /// The crossing point of edges i and j; independent of the cell that asks.
    std::optional<Point> crossing(int i, int j) const {
        const geometry::Segment2& s = segments_[i];
        const geometry::Segment2& t = segments_[j];
        if ((s.a.cwiseMin(s.b).array() > t.a.cwiseMax(t.b).array() + touching_).any() ||
            (t.a.cwiseMin(t.b).array() > s.a.cwiseMax(s.b).array() + touching_).any()) {
            return std::nullopt;
        }
        const int ta = side(s, t.a);
        const int tb = side(s, t.b);
        const int sa = side(t, s.a);
        const int sb = side(t, s.b);
        if (ta * tb < 0 && sa * sb < 0) {
            return meeting(s, t);
        }
        if (ta * tb > 0 || sa * sb > 0) {
            return std::nullopt;
        }
        if ((s.a - t.a).norm() <= touching_) {
            return passesCorner(i, j) ? std::optional(s.a) : std::nullopt;
        }
        if (ta == 0 && isInside(s, t.a) && side(s, before(j)) * tb < 0) {
            return t.a;
        }
        if (sa == 0 && isInside(t, s.a) && side(t, before(i)) * sb < 0) {
            return s.a;
        }
        if (ta == 0 && tb == 0 && sa == 0 && sb == 0 && (s.b - s.a).dot(t.b - t.a) > 0) {
            return middleOfOverlap(s, t);
        }
        return std::nullopt;
    }

    const Point& before(int i) const { return segments_[i > 0 ? i - 1 : n_ - 1].a; }

    /// 1 left of the line, -1 right of it, 0 within touching distance of it.
    int side(const Point& p, const Point& q, const Point& r) const {
        const Point along = q - p;
        const Point to = r - p;
        const double doubledArea = geometry::cross(along, to);
        return std::abs(doubledArea) <= touching_ * along.norm()
                   ? 0
                   : geometry::exactOrientation(p, q, r);
    }

    int side(const geometry::Segment2& s, const Point& r) const { return side(s.a, s.b, r); }

    /// For a point on the segment's line: true if it is between the ends, not at one.
    bool isInside(const geometry::Segment2& s, const Point& p) const {
        const Point along = s.b - s.a;
        return (p - s.a).dot(along) > touching_ * along.norm() &&
               (s.b - p).dot(along) > touching_ * along.norm();
    }

    static Point meeting(const geometry::Segment2& s, const geometry::Segment2& t) {
        const Point along = t.b - t.a;
        const auto height = [&](const Point& p) {
            return along.x() * (p.y() - t.a.y()) - along.y() * (p.x() - t.a.x());
        };
        const double share = height(s.a) / (height(s.a) - height(s.b));
        const Point onS = s.a + share * (s.b - s.a);
        // For nearly parallel edges rounding may put this beyond an end of t.
        const double onT = (onS - t.a).dot(along) / along.squaredNorm();
        return onT < 0 ? t.a : (onT > 1 ? t.b : onS);
    }

    /// For edges on one line in the same direction: the middle of their overlap.
    std::optional<Point> middleOfOverlap(const geometry::Segment2& s,
                                         const geometry::Segment2& t) const {
        const Point along = (s.b - s.a).normalized();
        const double from = std::max(0.0, (t.a - s.a).dot(along));
        const double to = std::min((s.b - s.a).norm(), (t.b - s.a).dot(along));
        return to - from > touching_ ? std::optional<Point>(s.a + 0.5 * (from + to) * along)
                                     : std::nullopt;
    }

    bool isSameRay(const Point& from, const Point& u, const Point& v) const {
        return (u - from).dot(v - from) > 0 && (side(from, u, v) == 0 || side(from, v, u) == 0);
    }

    /// For corners i and j at one place: whether the outline at j passes from one side of the
    /// outline at i to the other, or both leave along each other.
    bool passesCorner(int i, int j) const {
        const Point& corner = segments_[i].a;
        const Point& in = before(i);
        const Point& out = segments_[i].b;
        if (isSameRay(corner, out, segments_[j].b)) {
            return true;
        }
        for (const Point* p : {&before(j), &segments_[j].b}) {
            if (isSameRay(corner, in, *p) || isSameRay(corner, out, *p)) {
                return false;
            }
        }
        const int turn = side(corner, out, in);
        const auto isLeft = [&](const Point& p) {
            const bool leftOfOut = side(corner, out, p) > 0;
            const bool rightOfIn = side(corner, in, p) < 0;
            return turn > 0 ? leftOfOut && rightOfIn : leftOfOut || rightOfIn;
        };
        return isLeft(before(j)) != isLeft(segments_[j].b);
    }

    int n_;
    std::vector<geometry::Segment2> segments_;
    double touching_ = 0;
};

}  // namespace

std::vector<OutlineCrossing> findOutlineCrossings(const Points2& Q,
                                                  const std::vector<int>& boundary) {
    return boundary.empty() ? std::vector<OutlineCrossing>()
                            : Outline(Q, boundary).crossings(0, kMaxOutlineCrossings);
}

bool outlineIsSimple(const Points2& Q, const std::vector<int>& boundary) {
    return boundary.empty() || Outline(Q, boundary).crossings(0, 1).empty();
}

int outlineCrossings(const Points2& Q, const std::vector<int>& boundary) {
    return static_cast<int>(findOutlineCrossings(Q, boundary).size());
}

int crossingsFrom(const Points2& Q, const std::vector<int>& boundary, int from, int most) {
    return static_cast<int>(Outline(Q, boundary).crossings(from, most).size());
}

}  // namespace toile
