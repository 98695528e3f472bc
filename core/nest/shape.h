// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/geometry/polygon.h"
#include "core/nest/exact_overlap.h"

// For the sources of this folder only.
namespace toile::nest {

struct Box {
    double left = 0, bottom = 0, right = 0, top = 0;
};

/// Circles inscribed in a shape one after the other, largest first, in single precision and padded
/// to a multiple of four by circles without a size: they only rank.
struct Circles {
    std::vector<float> x, y, radius;
};

/// A shape at one angle, as the search looks at it: about its own origin. One of many points is
/// looked at with fewer of them, around it; its box stays that of the shape itself.
struct Shape {
    std::vector<double> x, y;        ///< of all points, ring after ring
    std::vector<int> next;           ///< the point after each in its ring
    std::vector<int> ringStarts;     ///< the first point of each ring
    std::vector<double> rimX, rimY;  ///< around the shape itself, where it has fewer points here
    double slack = 0;                ///< how far these may lie beyond the box
    Circles circles;
    Box box;
    double area = 0;
    double hullRoot = 0;      ///< the square root of the area of its convex hull
    double diameter = 0;      ///< of the box
    std::vector<Shape> bare;  ///< without the gap, where obstacles ask for it; else none
};

/// As obstacles see it.
inline const Shape& bareOf(const Shape& shape) {
    return shape.bare.empty() ? shape : shape.bare.front();
}

/// Takes time: the circles are searched. Precondition: the outline has an area.
Shape makeShape(const Rings& rings);
/// The same, turned: quarter turns without rounding.
void turn(const Shape& shape, double angle, Shape& turned);

/// Cosine and sine; of whole quarter turns exactly.
Eigen::Vector2d wayOf(double angle);
/// The points of a convex hull, and those whose triangle with its sides is less than `near`.
std::vector<Eigen::Vector2d> hullOf(const geometry::Polygon& points, double near);

}  // namespace toile::nest
