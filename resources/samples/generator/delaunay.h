// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "triangle_net.h"
#include "vec.h"

namespace toile::samples {

/// Delaunay triangles of `points` inside the outline made of the first `outlineCount` points,
/// which run anti-clockwise. Points are inserted one by one in the given order (Lawson flips).
/// Throws std::logic_error where an outline edge is missing: the sampling is then too coarse.
TriangleNet triangulateInside(const std::vector<Vec2>& points, std::size_t outlineCount);

/// Twice the signed area of the triangle a, b, c; positive when anti-clockwise.
inline double doubleArea(Vec2 a, Vec2 b, Vec2 c) {
    return cross(b - a, c - a);
}

}  // namespace toile::samples
