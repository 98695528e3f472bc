// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/render/overlay_values.h"

namespace toile {

/// A place where an overlay's value is worse than all around it.
struct WorstSpot {
    int piece = 0;
    Eigen::Vector2d flat = Eigen::Vector2d::Zero();      ///< mm, the piece's own coordinates
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< mm, relative to Scene::origin
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< towards the fabric's right side, unit
    double value = 0;                                    ///< in the overlay's unit
};

/// Up to this many are worth a person's look at once.
inline constexpr int kMostWorstSpots = 5;

/// The worst places, the worst first by OverlayScale::severity, on the same piece well apart from
/// each other. Places that are far from the end of their side are left out, however few remain.
/// Values are those of single triangles, in the middle of which a spot lies.
/// Pure, thread-safe. Cost: linear, a tenth of a second at a million triangles.
std::vector<WorstSpot> worstSpots(const Scene& scene, const SheetPlaces& places, Overlay overlay,
                                  const OverlayScale& scale);

}  // namespace toile
