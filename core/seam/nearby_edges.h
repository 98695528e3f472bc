// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/seam/outline.h"

namespace toile {

/// A place where more edges lie within each other's reach than any garment has.
struct CrowdedPlace {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< mm
    int edges = 0;
};

struct NearbyEdges {
    std::vector<std::pair<int, int>> pairs;  ///< a < b, each once, sorted
    std::vector<CrowdedPlace> crowded;       ///< pairs are left out there
};

/// Outline edges, not in `skip`, that may come within the sum of their reaches (mm, per edge) of
/// each other: all such pairs, and some more, but for those in crowded places. The cells of an
/// octree are divided as long as that parts the edges in them, so that uneven sampling costs
/// nothing. Cost: n log n; memory linear in the edges, however they lie. Pure.
NearbyEdges nearbyEdges(const Outlines& outlines, const std::vector<char>& skip,
                        const std::vector<double>& reach);

}  // namespace toile
