// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

#include "core/base/units.h"
#include "core/geometry/segment.h"
#include "core/nest/item_rings.h"

namespace toile::nest {
namespace {

using Eigen::Vector2d;
using geometry::Polygon;

/// Maximum number of circles until this share of the area is covered ([GVW25]).
constexpr std::array<std::pair<std::size_t, double>, 3> kCircleLimits{
    {{kMaxCircles, 0.0}, {16, 0.8}, {8, 0.9}}};
constexpr std::size_t kLanes = 4;

constexpr std::size_t kFewPoints = 80, kEnoughPoints = 50;  // larger shapes are simplified
constexpr double kMaxSlack = 0.5, kMaxSlackShare = 0.001;   // mm, and share of the diameter
constexpr double kNearHullShare = 1e-9;                     // of the diameter: within rounding

struct Circle {
    Vector2d centre;
    double radius = 0;
};

/// Distance to the boundary and the circles; negative outside the area or in a circle.
/// @param enough  if the distance is less, the result may be any number from it to this
double roomAt(const Vector2d& p, const Rings& rings, const std::vector<Circle>& circles,
              double enough) {
    double toCircles = HUGE_VAL;
    for (const Circle& circle : circles) {
        toCircles = std::min(toCircles, (p - circle.centre).norm() - circle.radius);
    }
    if (toCircles <= enough) {
        return toCircles;
    }
    const double enoughSquare = enough > 0 ? enough * enough : -1;
    double square = HUGE_VAL;
    bool isIn = false;
    for (const Polygon& ring : rings) {
        if (square <= enoughSquare) {
            return enough;
        }
        for (Eigen::Index k = 0; k < ring.rows(); ++k) {
            const Vector2d a = ring.row(k), b = ring.row((k + 1) % ring.rows());
            const Vector2d way = a + geometry::nearestShare(p, a, b) * (b - a) - p;
            square = std::min(square, way.squaredNorm());
            if ((a.y() > p.y()) != (b.y() > p.y()) &&
                p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
                isIn = !isIn;
            }
        }
    }
    return std::min(toCircles, isIn ? std::sqrt(square) : -std::sqrt(square));
}

/// The largest circle in the remaining area, to 2 %: subdivides squares, most promising first.
Circle largestCircle(const Rings& rings, const std::vector<Circle>& circles) {
    constexpr double kTolerance = 0.02;
    constexpr Eigen::Index kMaxSquares = 2000, kMinSquares = 50, kMaxSteps = 160'000;
    Eigen::Index points = 1;
    for (const Polygon& ring : rings) {
        points += ring.rows();
    }
    const Eigen::Index most = std::clamp(kMaxSteps / points, kMinSquares, kMaxSquares);
    struct Square {
        Vector2d centre;
        double half, room;
        double most() const { return room + half * std::sqrt(2.0); }
        bool operator<(const Square& other) const { return most() < other.most(); }
    };
    const Vector2d low = rings[0].colwise().minCoeff(), high = rings[0].colwise().maxCoeff();
    const double half = (high - low).maxCoeff() / 2;
    Circle best;
    std::priority_queue<Square> squares;
    const auto add = [&](const Vector2d& centre, double size) {
        // A square that cannot have a better circle needs no exact distance.
        const double enough =
            std::min(best.radius, best.radius * (1 + kTolerance) - size * std::sqrt(2.0));
        const Square square{centre, size, roomAt(centre, rings, circles, enough)};
        if (square.room > best.radius) {
            best = {centre, square.room};
        }
        squares.push(square);
    };
    add((low + high) / 2, half);
    for (Eigen::Index k = 0; k < most && !squares.empty(); ++k) {
        const Square square = squares.top();
        squares.pop();
        if (square.most() <= best.radius * (1 + kTolerance)) {
            break;
        }
        const double quarter = square.half / 2;
        for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}) {
            add(square.centre + quarter * Vector2d(x, y), quarter);
        }
    }
    return best;
}

std::vector<Circle> inscribedCircles(const Rings& rings, double area, std::size_t most) {
    std::vector<Circle> circles;
    double covered = 0;
    while (circles.size() < most && std::ranges::none_of(kCircleLimits, [&](const auto& limit) {
               return circles.size() >= limit.first && covered >= limit.second * area;
           })) {
        const Circle circle = largestCircle(rings, circles);
        if (!(circle.radius > 0)) {
            break;
        }
        covered += kPi * circle.radius * circle.radius;
        circles.push_back(circle);
    }
    return circles;
}

Box boxOf(const Shape& shape) {
    const bool hasRim = !shape.rimX.empty();
    const auto [left, right] = std::ranges::minmax(hasRim ? shape.rimX : shape.x);
    const auto [bottom, top] = std::ranges::minmax(hasRim ? shape.rimY : shape.y);
    return {left, bottom, right, top};
}

}  // namespace

Vector2d wayOf(double angle) {
    const double quarters = angle / (kPi / 2), whole = std::round(quarters);
    if (std::abs(quarters - whole) < 1e-9) {
        static constexpr std::array<std::pair<int, int>, 4> kWays{
            {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
        const auto [x, y] = kWays[static_cast<std::size_t>(std::fmod(std::fmod(whole, 4) + 4, 4))];
        return {x, y};
    }
    return {std::cos(angle), std::sin(angle)};
}

std::vector<Vector2d> hullOf(const Polygon& points, double near) {
    std::vector<Vector2d> sorted;
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        sorted.emplace_back(points.row(k));
    }
    std::ranges::sort(sorted, {}, [](const Vector2d& p) { return std::pair(p.x(), p.y()); });
    std::vector<Vector2d> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t first = hull.size();
        for (const Vector2d& p : sorted) {
            while (hull.size() > first + 1 &&
                   geometry::cross(hull.back() - hull[hull.size() - 2], p - hull.back()) < -near) {
                hull.pop_back();
            }
            hull.push_back(p);
        }
        std::ranges::reverse(sorted);
    }
    return hull;
}

Shape makeShape(const Rings& all, std::size_t mostCircles) {
    Shape shape;
    std::size_t points = 0;
    for (const Polygon& ring : all) {
        points += static_cast<std::size_t>(ring.rows());
        shape.area += geometry::signedAreaOf(ring);
    }
    Rings fewer;
    if (points > kFewPoints) {
        const Vector2d sides = all[0].colwise().maxCoeff() - all[0].colwise().minCoeff();
        shape.slack = std::min(kMaxSlack, kMaxSlackShare * sides.norm());
        fewer = simplified(all, shape.slack, kEnoughPoints);
        for (const Vector2d& p : hullOf(all[0], kNearHullShare * sides.squaredNorm())) {
            shape.rimX.push_back(p.x());
            shape.rimY.push_back(p.y());
        }
    }
    const Rings& rings = fewer.empty() ? all : fewer;
    for (const Polygon& ring : rings) {
        const int first = static_cast<int>(shape.x.size()), count = static_cast<int>(ring.rows());
        shape.ringStarts.push_back(first);
        for (int k = 0; k < count; ++k) {
            shape.x.push_back(ring(k, 0));
            shape.y.push_back(ring(k, 1));
            shape.next.push_back(first + (k + 1) % count);
        }
    }
    shape.box = boxOf(shape);
    shape.hullRoot = std::sqrt(geometry::signedAreaOf(geometry::convexHull(rings[0])));
    const double width = shape.box.right - shape.box.left;
    const double height = shape.box.top - shape.box.bottom;
    shape.diameter = std::sqrt(width * width + height * height);
    for (const Circle& circle : inscribedCircles(rings, shape.area, mostCircles)) {
        shape.circles.x.push_back(static_cast<float>(circle.centre.x()));
        shape.circles.y.push_back(static_cast<float>(circle.centre.y()));
        shape.circles.radius.push_back(static_cast<float>(circle.radius));
    }
    while (shape.circles.x.empty() || shape.circles.x.size() % kLanes != 0) {
        shape.circles.x.push_back(shape.circles.x.empty() ? static_cast<float>(shape.x[0])
                                                          : shape.circles.x[0]);
        shape.circles.y.push_back(shape.circles.y.empty() ? static_cast<float>(shape.y[0])
                                                          : shape.circles.y[0]);
        shape.circles.radius.push_back(0);
    }
    return shape;
}

void turn(const Shape& shape, double angle, Shape& turned) {
    turned = shape;
    const Vector2d way = wayOf(angle);
    for (std::size_t k = 0; k < shape.x.size(); ++k) {
        turned.x[k] = way.x() * shape.x[k] - way.y() * shape.y[k];
        turned.y[k] = way.y() * shape.x[k] + way.x() * shape.y[k];
    }
    for (std::size_t k = 0; k < shape.rimX.size(); ++k) {
        turned.rimX[k] = way.x() * shape.rimX[k] - way.y() * shape.rimY[k];
        turned.rimY[k] = way.y() * shape.rimX[k] + way.x() * shape.rimY[k];
    }
    const float c = static_cast<float>(way.x()), s = static_cast<float>(way.y());
    for (std::size_t k = 0; k < shape.circles.x.size(); ++k) {
        turned.circles.x[k] = c * shape.circles.x[k] - s * shape.circles.y[k];
        turned.circles.y[k] = s * shape.circles.x[k] + c * shape.circles.y[k];
    }
    turned.box = boxOf(turned);
    for (std::size_t k = 0; k < shape.bare.size(); ++k) {
        turn(shape.bare[k], angle, turned.bare[k]);
    }
}

}  // namespace toile::nest
