// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/render/camera_3d.h"
#include "app/render/scene.h"

namespace toile {

/// What lies under the pointer.
struct GarmentHit {
    int piece;
    double distance;  ///< from the ray's origin, mm
};

/// Nearest triangle along the ray, from either side. Pieces whose box is missed cost nothing; the
/// others cost their triangles.
std::optional<GarmentHit> pickGarment(const Scene& scene, const Ray& ray);

/// Flat piece that covers a point of the sheet (mm); of several the last drawn.
std::optional<int> pickPattern(const Scene& scene, const Eigen::Vector2d& point);

}  // namespace toile
