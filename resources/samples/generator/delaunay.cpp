// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay.h"

#include <algorithm>
#include <stdexcept>

namespace toile::samples {

namespace {

/// True when `p` lies clearly inside the circle through the anti-clockwise triangle b, c, d on the
/// other side of b-c: the angles at `p` and `d` sum to more than two right angles. Four points on
/// one circle, as on a square grid, count as outside whatever the rounding.
bool isInCircle(Vec2 b, Vec2 c, Vec2 d, Vec2 p) {
    constexpr double kTie = 1e-9;  // sine of the excess angle
    const Vec2 pb = b - p;
    const Vec2 pc = c - p;
    const Vec2 db = b - d;
    const Vec2 dc = c - d;
    const double sine = cross(pb, pc) * dot(dc, db) + dot(pb, pc) * cross(dc, db);
    return sine < -kTie * length(pb) * length(pc) * length(db) * length(dc);
}

class Builder {
public:
    Builder(const std::vector<Vec2>& points, std::size_t outlineCount)
        : points_(points),
          count_(static_cast<int>(points.size())),
          outlineCount_(static_cast<int>(outlineCount)) {
        addFrame();
        for (int v = 0; v < count_; ++v) {
            insert(v);
        }
    }

    TriangleNet inside() {
        std::vector<bool> kept(net_.triangles.size(), true);
        std::vector<int> open;
        int outlineSides = 0;
        for (int t = 0; t < net_.size(); ++t) {
            for (int k = 0; k < 3; ++k) {
                if (net_.corner(t, k) >= count_ && kept[static_cast<std::size_t>(t)]) {
                    kept[static_cast<std::size_t>(t)] = false;
                    open.push_back(t);
                }
                outlineSides += isOutline(net_.corner(t, k), net_.corner(t, k + 1)) ? 1 : 0;
            }
        }
        if (outlineSides != 2 * outlineCount_) {
            throw std::logic_error("outline edge missing from the triangulation");
        }
        while (!open.empty()) {
            const int t = open.back();
            open.pop_back();
            for (int k = 0; k < 3; ++k) {
                const int other = net_.beside(t, k);
                if (other != Triangle::kNone && kept[static_cast<std::size_t>(other)] &&
                    !isOutline(net_.corner(t, k + 1), net_.corner(t, k + 2))) {
                    kept[static_cast<std::size_t>(other)] = false;
                    open.push_back(other);
                }
            }
        }
        net_.keep(kept);
        return std::move(net_);
    }

private:
    /// A triangle far around everything, its corners numbered after the last point.
    void addFrame() {
        Vec2 low = points_.front();
        Vec2 high = low;
        for (const Vec2 p : points_) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
        const Vec2 middle = 0.5 * (low + high);
        const double reach = 200.0 * length(high - low);
        points_.push_back(middle + Vec2{-reach, -reach});
        points_.push_back(middle + Vec2{reach, -reach});
        points_.push_back(middle + Vec2{0.0, reach});
        net_.triangles.push_back({{count_, count_ + 1, count_ + 2}, {-1, -1, -1}});
    }

    Vec2 at(int v) const { return points_[static_cast<std::size_t>(v)]; }

    bool isOutline(int a, int b) const {
        return a < outlineCount_ && b < outlineCount_ &&
               ((a + 1) % outlineCount_ == b || (b + 1) % outlineCount_ == a);
    }

    /// Walks from the last triangle towards `p`.
    int locate(Vec2 p) {
        int t = last_;
        for (int step = 0; step < net_.size() + 3; ++step) {
            int next = Triangle::kNone;
            for (int k = 0; k < 3 && next == Triangle::kNone; ++k) {
                // Start at another edge each step, so that the walk cannot run in circles.
                const int slot = k + step;
                if (doubleArea(at(net_.corner(t, slot + 1)), at(net_.corner(t, slot + 2)), p) <
                    0.0) {
                    next = net_.beside(t, slot);
                }
            }
            if (next == Triangle::kNone) {
                return t;
            }
            t = next;
        }
        throw std::logic_error("point location does not end");
    }

    void insert(int v) {
        const auto children = net_.splitTriangle(locate(at(v)), v);
        std::vector<int> suspects(children.begin(), children.end());
        while (!suspects.empty()) {
            const int t = suspects.back();
            suspects.pop_back();
            const int other = net_.beside(t, 0);
            if (other == Triangle::kNone) {
                continue;
            }
            const int beyond = net_.cornerBeyond(t, 0);
            const Vec2 b = at(net_.corner(t, 1));
            const Vec2 c = at(net_.corner(t, 2));
            if (isInCircle(b, c, at(beyond), at(v)) && doubleArea(at(v), b, at(beyond)) > 0.0 &&
                doubleArea(at(v), at(beyond), c) > 0.0) {
                net_.flipEdge(t, 0);
                suspects.push_back(t);
                suspects.push_back(other);
            }
        }
        last_ = children[0];
    }

    std::vector<Vec2> points_;
    int count_;
    int outlineCount_;
    TriangleNet net_;
    int last_ = 0;
};

}  // namespace

TriangleNet triangulateInside(const std::vector<Vec2>& points, std::size_t outlineCount) {
    return Builder(points, outlineCount).inside();
}

}  // namespace toile::samples
