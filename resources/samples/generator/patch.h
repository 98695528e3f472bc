// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "outline.h"
#include "triangle_net.h"

namespace toile::samples {

/// Where a point of the flat layout lies in space.
using Surface = std::function<Vec3(Vec2)>;

/// One piece while it is meshed: every vertex in its flat layout and in space. The outline comes
/// first, in order, and never moves.
struct Patch {
    std::vector<Vec2> flat;
    std::vector<Vec3> space;
    std::vector<bool> onFold;  ///< one per outline vertex, see Outline::Fold
    TriangleNet net;

    int outlineCount() const { return static_cast<int>(onFold.size()); }

    bool onOutline(int v) const { return v < outlineCount(); }

    Vec2 flatAt(int v) const { return flat[static_cast<std::size_t>(v)]; }

    Vec3 spaceAt(int v) const { return space[static_cast<std::size_t>(v)]; }
};

/// Meshes the inside of `outline` with near-equilateral triangles of about `edge` mm.
/// `surface` should be near-isometric and agree with the outline.
Patch meshPatch(const Outline& outline, const Surface& surface, double edge);

/// Turns, splits and moves what is inside the outline until the triangles are well shaped in
/// space and no inner edge joins two outline vertices, but for the tips of sharp corners.
void relaxPatch(Patch& patch, const Surface& surface, double edge);

}  // namespace toile::samples
