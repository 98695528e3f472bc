// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/collision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/units.h"

namespace toile::nest {
namespace {

constexpr std::size_t kCircleLanes = 4;
constexpr double kEpsilonShare = 0.01;  // of the larger diameter

struct Side {
    double x0, y0, x1, y1;
};

/// The edges of a moved shape that intersect a box.
void sidesIn(const Shape& shape, double dx, double dy, const Box& box, std::vector<Side>& sides) {
    sides.clear();
    const std::size_t count = shape.x.size();
    for (std::size_t k = 0; k < count; ++k) {
        const auto n = static_cast<std::size_t>(shape.next[k]);
        const Side side{shape.x[k] + dx, shape.y[k] + dy, shape.x[n] + dx, shape.y[n] + dy};
        if (std::max(side.x0, side.x1) >= box.left && std::min(side.x0, side.x1) <= box.right &&
            std::max(side.y0, side.y1) >= box.bottom && std::min(side.y0, side.y1) <= box.top) {
            sides.push_back(side);
        }
    }
}

/// The left of a side is inside, and points on its line are outside: so shapes that only touch do
/// not cross, and those that overlap cross also if they meet at their corners.
bool doCross(const Side& a, const Side& b) {
    const double ax = a.x1 - a.x0, ay = a.y1 - a.y0;
    const double s0 = ax * (b.y0 - a.y0) - ay * (b.x0 - a.x0);
    const double s1 = ax * (b.y1 - a.y0) - ay * (b.x1 - a.x0);
    if ((s0 > 0) == (s1 > 0)) {
        return false;
    }
    const double bx = b.x1 - b.x0, by = b.y1 - b.y0;
    const double t0 = bx * (a.y0 - b.y0) - by * (a.x0 - b.x0);
    const double t1 = bx * (a.y1 - b.y0) - by * (a.x1 - b.x0);
    return (t0 > 0) != (t1 > 0);
}

bool isInShape(const Shape& shape, double x, double y) {
    if (!(x > shape.box.left && x < shape.box.right && y > shape.box.bottom && y < shape.box.top)) {
        return false;
    }
    bool isIn = false;
    for (std::size_t k = 0; k < shape.x.size(); ++k) {
        const auto n = static_cast<std::size_t>(shape.next[k]);
        if ((shape.y[k] > y) != (shape.y[n] > y) &&
            x < shape.x[k] +
                    (y - shape.y[k]) / (shape.y[n] - shape.y[k]) * (shape.x[n] - shape.x[k])) {
            isIn = !isIn;
        }
    }
    return isIn;
}

/// Whether the largest circles intersect, which detects most collisions.
bool doLargestMeet(const Circles& a, const Circles& b, float dx, float dy) {
    for (std::size_t i = 0; i < kCircleLanes; ++i) {
        for (std::size_t k = 0; k < kCircleLanes; ++k) {
            const float x = b.x[k] + dx - a.x[i], y = b.y[k] + dy - a.y[i];
            // Slightly less, because single precision rounds.
            const float reach = 0.9999f * (a.radius[i] + b.radius[k]);
            if (a.radius[i] > 0 && b.radius[k] > 0 && x * x + y * y < reach * reach) {
                return true;
            }
        }
    }
    return false;
}

/// Tests a point of each ring and the centre of the largest circle, if no edges cross.
bool isAPartInside(const Shape& a, const Shape& b, double dx, double dy) {
    return isInShape(b, static_cast<double>(a.circles.x[0]) - dx,
                     static_cast<double>(a.circles.y[0]) - dy) ||
           std::ranges::any_of(a.ringStarts, [&](int k) {
               const auto start = static_cast<std::size_t>(k);
               return isInShape(b, a.x[start] - dx, a.y[start] - dy);
           });
}

}  // namespace

bool doCollide(const Shape& a, const Shape& b, double dx, double dy) {
    const Box common{std::max(a.box.left, b.box.left + dx),
                     std::max(a.box.bottom, b.box.bottom + dy),
                     std::min(a.box.right, b.box.right + dx), std::min(a.box.top, b.box.top + dy)};
    if (!(common.left < common.right && common.bottom < common.top)) {
        return false;
    }
    if (doLargestMeet(a.circles, b.circles, static_cast<float>(dx), static_cast<float>(dy))) {
        return true;
    }
    const double slack = a.slack + b.slack;
    const Box reached{common.left - slack, common.bottom - slack, common.right + slack,
                      common.top + slack};
    thread_local std::vector<Side> ofA, ofB;
    sidesIn(a, 0, 0, reached, ofA);
    if (!ofA.empty()) {
        sidesIn(b, dx, dy, reached, ofB);
        for (const Side& side : ofA) {
            const double left = std::min(side.x0, side.x1), right = std::max(side.x0, side.x1);
            for (const Side& other : ofB) {
                if (std::max(other.x0, other.x1) >= left && std::min(other.x0, other.x1) <= right &&
                    doCross(side, other)) {
                    return true;
                }
            }
        }
    }
    return isAPartInside(a, b, dx, dy) || isAPartInside(b, a, -dx, -dy);
}

double collisionLoss(const Shape& a, const Shape& b, double dx, double dy) {
    const float epsilon = static_cast<float>(kEpsilonShare * std::max(a.diameter, b.diameter));
    const float square = epsilon * epsilon, twice = 2 * epsilon;
    const float moveX = static_cast<float>(dx), moveY = static_cast<float>(dy);
    std::array<float, kCircleLanes> sums{};
    const std::size_t countA = a.circles.x.size(), countB = b.circles.x.size();
    const float* const bx = b.circles.x.data();
    const float* const by = b.circles.y.data();
    const float* const br = b.circles.radius.data();
    for (std::size_t i = 0; i < countA; ++i) {
        const float x = a.circles.x[i] - moveX, y = a.circles.y[i] - moveY, r = a.circles.radius[i];
        for (std::size_t k = 0; k < countB; k += kCircleLanes) {
            for (std::size_t lane = 0; lane < kCircleLanes; ++lane) {
                const float ux = bx[k + lane] - x, uy = by[k + lane] - y, s = br[k + lane];
                const float depth = r + s - std::sqrt(ux * ux + uy * uy);
                const float outside = square / (twice - std::min(depth, epsilon));
                const float felt = depth >= epsilon ? depth : outside;
                sums[lane] += std::min(r, s) * felt;
            }
        }
    }
    const double overlap = kPi * static_cast<double>((sums[0] + sums[1]) + (sums[2] + sums[3]));
    const double eps = static_cast<double>(epsilon);
    return std::sqrt(overlap + eps * eps) * std::sqrt(a.hullRoot * b.hullRoot);
}

}  // namespace toile::nest
