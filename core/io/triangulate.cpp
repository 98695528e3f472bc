// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/triangulate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/base/units.h"
#include "core/geometry/segment.h"
#include "core/io/soup_builder.h"

namespace toile::geometry {
namespace {

/// Corners of a polygon's triangles, as indices into the polygon's corners; anti-clockwise if the
/// polygon is.
using EarTriangles = std::vector<std::array<int, 3>>;

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

/// Divides a simple polygon into #corners - 2 triangles, cutting the best-shaped ear first, so that
/// corners on a straight line give no flat triangle if that can be avoided. Repeated positions and
/// edges that touch are tolerated.
/// @param polygon  at least 3 corners, anti-clockwise; any unit, extents of about 1
/// @return nothing if the polygon crosses itself
/// Cost: quadratic in the corners.
EarTriangles clipEars(const std::vector<Eigen::Vector2d>& polygon) {
    return crossesItself(polygon) ? EarTriangles{} : EarClipper(polygon).run();
}

}  // namespace

}  // namespace toile::geometry

namespace toile {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// A larger polygon becomes a fan: clipping its ears would take seconds, and no garment has one.
constexpr int kMaxEarCorners = 4000;

/// Quality of a diagonal in a quad: the worse shape of the two triangles (signed height relative to
/// the longest edge). Corners a, b, c, d with the diagonal from a to c.
double diagonalShape(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d,
                     const Vector3d& normal) {
    const auto shape = [&](const Vector3d& p, const Vector3d& q, const Vector3d& r) {
        const double longest2 =
            std::max({(q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm()});
        return longest2 > 0 ? (q - p).cross(r - p).dot(normal) / longest2 : 0.0;
    };
    return std::min(shape(a, b, c), shape(a, c, d));
}

class Triangulator {
public:
    Triangulator(const PolygonSoup& soup, std::string name) : soup_(soup), name_(std::move(name)) {
        const std::size_t faces = static_cast<std::size_t>(soup.faceCount());
        const std::size_t triangles = soup.corners.size() - 2 * faces;
        result_.F.resize(static_cast<Eigen::Index>(triangles), 3);
        result_.sourceFace.reserve(triangles);
    }

    Triangulation run() {
        for (face_ = 0; face_ < soup_.faceCount(); ++face_) {
            if (isUsable()) {
                divide();
            }
        }
        result_.F.conservativeResize(static_cast<Eigen::Index>(result_.sourceFace.size()), 3);
        result_.problems = counter_.problems(name_);
        return std::move(result_);
    }

private:
    int cornerCount() const { return soup_.cornerCount(face_); }

    int vertex(int corner) const { return soup_.corners[soup_.faceStart[face_] + corner]; }

    const Vector3d& position(int corner) const { return soup_.positions[vertex(corner)]; }

    bool isUsable() {
        for (int i = 0; i < cornerCount(); ++i) {
            if (!position(i).allFinite()) {
                counter_.add(ErrorCode::NonFinitePosition, "face", toile::translatable("left out"),
                             face_ + 1);
                return false;
            }
        }
        isBridged_ = repeatsCorner();
        if (isBridged_ && !hasBridges()) {
            leaveOutRepeated();
            return false;
        }
        return true;
    }

    void leaveOutRepeated() {
        counter_.add(ErrorCode::DegenerateFaceRecord, "face",
                     toile::translatable("left out: a corner is repeated"), face_ + 1);
    }

    /// Whether the polygon has holes that edges walked in both directions join to its rim, and no
    /// other repeated corners.
    bool hasBridges() {
        constexpr int kMinCorners = 8;  // a triangle in a triangle, and the bridge
        if (cornerCount() < kMinCorners || cornerCount() > kMaxEarCorners) {
            return false;
        }
        std::set<std::pair<int, int>> edges;
        for (int i = 0; i < cornerCount(); ++i) {
            edges.emplace(vertex(i), vertex((i + 1) % cornerCount()));
        }
        std::map<int, int> walked;  // per corner: how often it occurs, or 0 at the end of a bridge
        for (int i = 0; i < cornerCount(); ++i) {
            ++walked[vertex(i)];
        }
        for (const auto& [from, to] : edges) {
            walked[from] = from != to && edges.contains({to, from}) ? 0 : walked[from];
        }
        return static_cast<int>(edges.size()) == cornerCount() &&
               std::ranges::all_of(walked, [](const auto& corner) { return corner.second < 2; });
    }

    bool repeatsCorner() {
        if (cornerCount() == 3) {
            return vertex(0) == vertex(1) || vertex(1) == vertex(2) || vertex(2) == vertex(0);
        }
        sorted_.assign(soup_.corners.begin() + soup_.faceStart[face_],
                       soup_.corners.begin() + soup_.faceStart[face_ + 1]);
        std::sort(sorted_.begin(), sorted_.end());
        return std::adjacent_find(sorted_.begin(), sorted_.end()) != sorted_.end();
    }

    void divide() {
        if (cornerCount() == 3) {
            add(0, 1, 2);
        } else if (cornerCount() > kMaxEarCorners) {
            fan(toile::translatable("split as a fan: too many corners"));
        } else {
            localise();
            cornerCount() == 4 ? divideQuad() : divideLarger();
        }
    }

    /// Positions relative to the first corner, scaled to extents of about 1 by a power of two, so
    /// that no digits are lost far from the origin or at any scale.
    void localise() {
        local_.clear();
        double extent = 0;
        for (int i = 0; i < cornerCount(); ++i) {
            local_.push_back(position(i) - position(0));
            extent = std::max(extent, local_.back().cwiseAbs().maxCoeff());
        }
        const int exponent = extent > 0 ? std::ilogb(extent) : 0;
        for (Vector3d& p : local_) {
            p = p.unaryExpr([exponent](double x) { return std::ldexp(x, -exponent); });
        }
    }

    /// Newell's normal, of length 1; 0 if the polygon has no area.
    Vector3d normal() const {
        Vector3d sum = Vector3d::Zero();
        double size = 0;
        for (std::size_t i = 1; i + 1 < local_.size(); ++i) {
            const Vector3d part = local_[i].cross(local_[i + 1]);
            sum += part;
            size += part.norm();
        }
        return sum.norm() > kDegenerateHeight * size ? sum.normalized() : Vector3d::Zero();
    }

    void divideQuad() {
        const Vector3d n = normal();
        const double s02 = diagonalShape(local_[0], local_[1], local_[2], local_[3], n);
        const double s13 = diagonalShape(local_[1], local_[2], local_[3], local_[0], n);
        const bool shorter02 = local_[2].squaredNorm() <= (local_[3] - local_[1]).squaredNorm();
        const bool bothInside = std::min(s02, s13) > kDegenerateHeight;
        if (n.isZero(0) || std::max(s02, s13) < -kDegenerateHeight) {
            fan(kCrossing);
        } else if (bothInside ? shorter02 : s02 >= s13) {
            add(0, 1, 2);
            add(0, 2, 3);
        } else {
            add(0, 1, 3);
            add(1, 2, 3);
        }
    }

    void divideLarger() {
        const Vector3d n = normal();
        const geometry::EarTriangles triangles =
            n.isZero(0) ? geometry::EarTriangles{} : geometry::clipEars(projected(n));
        const auto repeats = [this](const std::array<int, 3>& corners) {
            const int a = vertex(corners[0]), b = vertex(corners[1]), c = vertex(corners[2]);
            return a == b || b == c || c == a;
        };
        if (isBridged_ && (triangles.empty() || std::ranges::any_of(triangles, repeats))) {
            leaveOutRepeated();
            return;
        }
        if (triangles.empty()) {
            fan(kCrossing);
        }
        for (const auto& [a, b, c] : triangles) {
            add(a, b, c);
        }
    }

    /// Projects the polygon along the axis closest to its normal, anti-clockwise: drops a
    /// coordinate instead of computing, so corners on a line stay on a line.
    std::vector<Vector2d> projected(const Vector3d& n) const {
        int axis = 0;
        n.cwiseAbs().maxCoeff(&axis);
        int x = (axis + 1) % 3, y = (axis + 2) % 3;
        if (n[axis] < 0) {
            std::swap(x, y);
        }
        std::vector<Vector2d> points;
        points.reserve(local_.size());
        for (const Vector3d& p : local_) {
            points.emplace_back(p[x], p[y]);
        }
        return points;
    }

    void fan(const char* why) {
        counter_.add(ErrorCode::PolygonNotSimple, "face", why, face_ + 1);
        for (int i = 1; i + 1 < cornerCount(); ++i) {
            add(0, i, i + 1);
        }
    }

    void add(int a, int b, int c) {
        const auto row = static_cast<Eigen::Index>(result_.sourceFace.size());
        result_.F.row(row) << vertex(a), vertex(b), vertex(c);
        result_.sourceFace.push_back(face_);
    }

    static constexpr const char* kCrossing =
        toile::translatable("split as a fan: it crosses itself or has no area");

    const PolygonSoup& soup_;
    std::string name_;
    io::ProblemCounter counter_{"face"};
    Triangulation result_;
    int face_ = 0;
    bool isBridged_ = false;  ///< corners of the face are repeated where bridges to holes end
    std::vector<int> sorted_;
    std::vector<Vector3d> local_;
};

}  // namespace

Triangulation triangulate(const PolygonSoup& soup, const std::string& name) {
    return Triangulator(soup, name).run();
}

}  // namespace toile
