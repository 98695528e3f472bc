// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "app/render/scene.h"
#include "core/project/piece_settings.h"

namespace toile {

/// What the pattern view knows of one piece beyond its shape.
struct SheetPlace {
    Placement placement{};
    double grain = kGrainUpwards;  ///< direction of the warp in the piece's own coordinates
    int colour = 0;                ///< its number (`pieceColour`)

    bool operator==(const SheetPlace&) const = default;
};

/// One per piece of the scene. Shorter lists stand for pieces that lie where they were made.
using SheetPlaces = std::vector<SheetPlace>;

/// @param colours  one per piece, or none where nobody asks
SheetPlaces placesOf(const std::vector<PieceSettings>& settings,
                     const std::vector<int>& colours = {});

const SheetPlace& placeOf(const SheetPlaces& places, int piece);

/// The smallest upright box around a box of the piece at its place; empty where that is empty.
Eigen::AlignedBox2d placedBox(const Eigen::AlignedBox2d& box, const Placement& placement);

/// Around both sides of a seam at their places; empty where neither is flat.
Eigen::AlignedBox2d placedBox(const SeamScene& seam, const SheetPlaces& places);

/// Around all flat pieces of the scene at their places.
Eigen::AlignedBox2d sheetBox(const Scene& scene, const SheetPlaces& places);

}  // namespace toile
