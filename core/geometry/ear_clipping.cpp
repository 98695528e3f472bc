// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/ear_clipping.h"

#include <algorithm>
#include <limits>

#include "core/base/tolerances.h"
#include "core/geometry/segment.h"

namespace toile::geometry {
namespace {

using Eigen::Vector2d;

/// Twice the signed area of a triangle: positive if it runs anti-clockwise.
double orientation(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
    return cross(b - a, c - a);
}

/// Signed height over the longest edge, relative to that edge; 0 if all three are one point.
double shape(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
    const double longest2 =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return longest2 > 0 ? orientation(a, b, c) / longest2 : 0;
}

bool properlyCross(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
    const double abc = orientation(a, b, c), abd = orientation(a, b, d);
    const double cda = orientation(c, d, a), cdb = orientation(c, d, b);
    return ((abc > 0 && abd < 0) || (abc < 0 && abd > 0)) &&
           ((cda > 0 && cdb < 0) || (cda < 0 && cdb > 0));
}

bool crossesItself(const std::vector<Vector2d>& polygon) {
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i + 2 < n; ++i) {
        for (std::size_t j = i + 2; j < n; ++j) {
            if (properlyCross(polygon[i], polygon[i + 1], polygon[j], polygon[(j + 1) % n])) {
                return true;
            }
        }
    }
    return false;
}

/// How strictly an ear is judged. Each level is tried if the one before leaves no ear.
struct Strictness {
    double leastShape;  ///< an ear must be better shaped than this
    double margin;      ///< a corner this far outside of an edge, by its length, is still inside
};

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr Strictness kStrictness[] = {
    {kDegenerateHeight, kDegenerateHeight},    // no flat triangles
    {0, 0},                                    // thin ones, but every corner counts
    {-kDegenerateHeight, -kDegenerateHeight},  // flat ones, and corners may lie on the edges
};

class EarClipper {
public:
    explicit EarClipper(const std::vector<Vector2d>& polygon)
        : p_(polygon),
          n_(static_cast<int>(polygon.size())),
          previous_(polygon.size()),
          next_(polygon.size()),
          quality_(polygon.size()) {
        for (int i = 0; i < n_; ++i) {
            previous_[i] = (i + n_ - 1) % n_;
            next_[i] = (i + 1) % n_;
        }
    }

    EarTriangles run() {
        EarTriangles triangles;
        triangles.reserve(p_.size() - 2);
        int left = n_;
        for (const Strictness& level : kStrictness) {
            level_ = level;
            judgeAll();
            for (int ear = best(); left > 3 && ear >= 0; ear = best(), --left) {
                triangles.push_back({previous_[ear], ear, next_[ear]});
                cut(ear);
            }
            if (left == 3) {
                const int a = previous_[anyLeft_], b = anyLeft_, c = next_[anyLeft_];
                triangles.push_back({a, b, c});
                const bool folded = shape(p_[a], p_[b], p_[c]) < -kDegenerateHeight;
                return folded ? EarTriangles{} : triangles;
            }
        }
        return {};
    }

private:
    void judgeAll() {
        int i = anyLeft_;
        do {
            judge(i);
            i = next_[i];
        } while (i != anyLeft_);
    }

    /// Sets the quality of a corner as an ear; minus infinity if it is not an ear.
    void judge(int i) {
        const Vector2d &a = p_[previous_[i]], &b = p_[i], &c = p_[next_[i]];
        const double value = shape(a, b, c);
        quality_[i] =
            value > level_.leastShape && isFree(previous_[i], next_[i], a, b, c) ? value : -kNever;
    }

    /// True if no other corner lies in the triangle. Other corners at the position of one of its
    /// own do not count: the polygon touches itself there.
    bool isFree(int first, int last, const Vector2d& a, const Vector2d& b,
                const Vector2d& c) const {
        const double ab = level_.margin * (b - a).norm();
        const double bc = level_.margin * (c - b).norm();
        const double ca = level_.margin * (a - c).norm();
        for (int k = next_[last]; k != first; k = next_[k]) {
            const Vector2d& q = p_[k];
            if (orientation(a, b, q) >= -ab && orientation(b, c, q) >= -bc &&
                orientation(c, a, q) >= -ca && q != a && q != b && q != c) {
                return false;
            }
        }
        return true;
    }

    int best() const {
        int found = -1, i = anyLeft_;
        double quality = -kNever;
        do {
            if (quality_[i] > quality) {
                quality = quality_[i];
                found = i;
            }
            i = next_[i];
        } while (i != anyLeft_);
        return found;
    }

    void cut(int ear) {
        const int before = previous_[ear], after = next_[ear];
        next_[before] = after;
        previous_[after] = before;
        anyLeft_ = before;
        judge(before);
        judge(after);
    }

    const std::vector<Vector2d>& p_;
    int n_;
    std::vector<int> previous_, next_;
    std::vector<double> quality_;
    Strictness level_{};
    int anyLeft_ = 0;
};

}  // namespace

EarTriangles clipEars(const std::vector<Eigen::Vector2d>& polygon) {
    return crossesItself(polygon) ? EarTriangles{} : EarClipper(polygon).run();
}

}  // namespace toile::geometry
