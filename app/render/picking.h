// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/render/camera_3d.h"
#include "app/render/scene.h"
#include "app/render/sheet_places.h"

namespace toile {

/// A place on the cloth, under the pointer.
struct SurfaceHit {
    int piece = -1;
    int face = -1;                                          ///< of the piece's mesh
    Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();  ///< weights of the face's corners
    double distance = 0;  ///< from the ray's origin, mm; 0 in the pattern
};

/// Nearest triangle along the ray, from either side; of equals the first. Looked up in the trees of
/// the pieces: microseconds, with a million triangles too.
std::optional<SurfaceHit> pickGarment(const Scene& scene, const Ray& ray);

/// The place of a flat piece that covers a point of the sheet (mm); of several the last drawn.
std::optional<SurfaceHit> pickPattern(const Scene& scene, const SheetPlaces& places,
                                      const Eigen::Vector2d& point);

/// The place of one flat piece at a point of its own coordinates.
std::optional<SurfaceHit> pickPiece(const Scene& scene, int piece, const Eigen::Vector2d& point);

/// A place on a piece: relative to Scene::origin, and in the flat piece's own coordinates (only of
/// one that is flat). Precondition: the face is of the piece's mesh.
Eigen::Vector3d garmentPoint(const Scene& scene, int piece, int face,
                             const Eigen::Vector3d& barycentric);
Eigen::Vector2d patternPoint(const Scene& scene, int piece, int face,
                             const Eigen::Vector3d& barycentric);

}  // namespace toile
