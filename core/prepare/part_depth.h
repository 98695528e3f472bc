// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/prepare/surface_parts.h"

namespace toile::layers {

/// How deep a connected part lies inside others.
struct PartDepth {
    int layer = 0;        ///< number of parts outside it, close to it over most of its area
    double inside = 0;    ///< share of its area that has others outside it
    double onOthers = 0;  ///< and with others on either side
    /// The outer side was found; else the side of earlier parts in the file counts as outside.
    bool isSure = true;
    std::map<int, double> near{};  ///< area, mm2, per adjacent part
};

struct PartDepths {
    std::vector<PartDepth> parts;                 ///< one per part; empty after a cancel
    std::vector<std::pair<double, double>> gaps;  ///< between adjacent layers, mm, with areas
};

/// Looks outwards from parts. Outside is the side with nothing behind adjacent parts: a garment's
/// front has its back on the other side. If that cannot be seen, the convex side is outside.
/// @param surface  mm, each face once   @param parts  of it
/// Cost: n log n, and rays of at most 400 triangles of each part. Pure.
PartDepths depthsOf(const FileSurface& surface, const SurfaceParts& parts,
                    const Progress& progress);

}  // namespace toile::layers
