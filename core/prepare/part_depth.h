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
    int layer = 0;        ///< how many others lie outside it, near it over most of its area
    double inside = 0;    ///< share of its area that has others outside it
    double onOthers = 0;  ///< and that has others on either side
    /// Which side is outside was seen; else it is the side of what comes earlier in the file.
    bool isSure = true;
    std::map<int, double> near{};  ///< area, mm2, by the part that is next to it there
};

struct PartDepths {
    std::vector<PartDepth> parts;  ///< as many as there are parts, but after a cancel
    std::vector<std::pair<double, double>> gaps;  ///< from one to the next, mm, with areas
};

/// Looks outwards from parts. Outside is where nothing comes behind what lies near, as on the other
/// side of a garment's front its back does; where that is not seen, on the bulging side.
/// @param surface  mm, each face once   @param parts  of it
/// Cost: n log n, and rays of at most 400 triangles of each part. Pure.
PartDepths depthsOf(const FileSurface& surface, const SurfaceParts& parts,
                    const Progress& progress);

}  // namespace toile::layers
