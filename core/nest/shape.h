// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/geometry/polygon.h"

// For the sources of this folder only.
namespace toile::nest {

/// The outline of a shape and its holes.
using Rings = std::vector<geometry::Polygon>;

struct Box {
    double left = 0, bottom = 0, right = 0, top = 0;
};

/// Circles inscribed in a shape one after the other, largest first, in single precision and padded
/// to a multiple of four by circles of size zero: used only for ranking.
struct Circles {
    std::vector<float> x, y, radius;
};

/// A shape at one angle for the search, about its own origin. A shape of many points is replaced by
/// a simpler one around it; its box remains that of the shape itself.
struct Shape {
    std::vector<double> x, y;        ///< of all points, ring after ring
    std::vector<int> next;           ///< the point after each in its ring
    std::vector<int> ringStarts;     ///< the first point of each ring
    std::vector<double> rimX, rimY;  ///< of the shape itself, if it is simplified here
    double slack = 0;                ///< how far the simplified points may lie outside the box
    Circles circles;
    Box box;
    double area = 0;
    double hullRoot = 0;      ///< the square root of the area of its convex hull
    double diameter = 0;      ///< of the box
    std::vector<Shape> bare;  ///< without the gap, if obstacles need it; else empty
};

/// The shape for tests with obstacles.
inline const Shape& bareOf(const Shape& shape) {
    return shape.bare.empty() ? shape : shape.bare.front();
}

inline constexpr std::size_t kMaxCircles = 64;

/// Slow: searches the circles, so give less of them to each of many shapes. Precondition: the
/// outline has an area.
Shape makeShape(const Rings& rings, std::size_t mostCircles = kMaxCircles);
/// Rotates the shape: quarter turns without rounding.
void turn(const Shape& shape, double angle, Shape& turned);

/// Cosine and sine; exact for whole quarter turns.
Eigen::Vector2d wayOf(double angle);
/// The corners of a convex hull, and points that close: twice their triangle's area below `near`.
std::vector<Eigen::Vector2d> hullOf(const geometry::Polygon& points, double near);

}  // namespace toile::nest
