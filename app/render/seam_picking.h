// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "app/render/camera_3d.h"
#include "app/render/scene.h"
#include "app/render/sheet_places.h"

namespace toile {

/// A seam under the pointer.
struct SeamHit {
    int seam = -1;        ///< index into Scene::seams
    int side = 0;         ///< 0 left, 1 right
    int segment = 0;      ///< of the side's polyline, counted along the seam
    double distance = 0;  ///< in the pattern mm; in the garment as a part of the depth
};

/// Which seams count; an empty one lets all in.
using SeamFilter = std::function<bool(int seam)>;

/// The seam nearest to a point of the sheet, of those within `radius` mm; of equals the first.
/// Cost: a box per seam, and the segments of those that are near. Pure.
std::optional<SeamHit> pickPatternSeam(const Scene& scene, const SheetPlaces& places,
                                       const Eigen::Vector2d& point, double radius,
                                       const SeamFilter& counts = {});

/// The seam nearest to a ray.
/// @param slope     how far beside the ray a seam may lie, per mm of depth
/// @param farthest  seams deeper than this along the ray are hidden, mm
std::optional<SeamHit> pickGarmentSeam(const Scene& scene, const Ray& ray, double slope,
                                       double farthest, const SeamFilter& counts = {});

}  // namespace toile
