// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch.h"

#include <algorithm>

#include "delaunay.h"

namespace toile::samples {

namespace {

constexpr double kOutlineClearance = 0.55;  // of an edge: nearer grid points crowd the outline

double distanceToSegment(Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 along = b - a;
    const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
    return length(p - (a + t * along));
}

/// Inside and not too near the outline: even-odd rule and distance in one round.
bool isRoomyInside(Vec2 p, const std::vector<Vec2>& outline, double clearance) {
    bool inside = false;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2 a = outline[k];
        const Vec2 b = outline[(k + 1) % outline.size()];
        if (distanceToSegment(p, a, b) < clearance) {
            return false;
        }
        if ((a.y > p.y) != (b.y > p.y) && a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x) {
            inside = !inside;
        }
    }
    return inside;
}

/// Points of a triangular grid inside the outline, row by row.
std::vector<Vec2> gridInside(const std::vector<Vec2>& outline, double edge) {
    Vec2 low = outline.front();
    Vec2 high = low;
    for (const Vec2 p : outline) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double rise = edge * std::sqrt(3.0) / 2.0;
    std::vector<Vec2> grid;
    const int rows = static_cast<int>((high.y - low.y) / rise);
    const int columns = static_cast<int>((high.x - low.x) / edge) + 1;
    for (int row = 1; row <= rows; ++row) {
        const double shift = row % 2 == 0 ? 0.0 : 0.5 * edge;
        for (int column = 0; column <= columns; ++column) {
            const Vec2 p{low.x + shift + column * edge, low.y + row * rise};
            if (isRoomyInside(p, outline, kOutlineClearance * edge)) {
                grid.push_back(p);
            }
        }
    }
    return grid;
}

}  // namespace

Patch meshPatch(const Outline& outline, const Surface& surface, double edge) {
    Patch patch;
    patch.flat = outline.flat();
    patch.space = outline.space();
    patch.onFold = outline.onFold();
    for (const Vec2 p : gridInside(outline.flat(), edge)) {
        patch.flat.push_back(p);
        patch.space.push_back(surface(p));
    }
    patch.net = triangulateInside(patch.flat, outline.flat().size());
    relaxPatch(patch, surface, edge);
    return patch;
}

}  // namespace toile::samples
