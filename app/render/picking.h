// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "app/render/camera.h"
#include "app/render/scene.h"

namespace toile::app {

/// A place on the cloth, under the pointer.
struct SurfaceHit {
    int piece = -1;
    int face = -1;  ///< of the piece's mesh
    /// Weights of the face's corners.
    Eigen::Vector3d barycentric = Eigen::Vector3d::Constant(1.0 / 3);
    double distance = 0;  ///< from the ray's origin, mm; 0 in the pattern
};

/// Nearest triangle along the ray, from either side; of equals the first. Looked up in the trees of
/// the pieces: microseconds, with a million triangles too.
/// @param places  hidden pieces are not there, for the picks below too; none: all are seen
std::optional<SurfaceHit> pickGarment(const Scene& scene, const Ray& ray,
                                      const SheetPlaces& places = {});

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

/// A seam under the pointer.
struct SeamHit {
    int seam = -1;        ///< index into Scene::seams
    int side = 0;         ///< 0 left, 1 right
    int segment = 0;      ///< of the side's polyline, counted along the seam
    double distance = 0;  ///< in the pattern mm; in the garment as a part of the depth
    double along = 0;     ///< how far along the side, as a part of its length on the garment
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
                                       double farthest, const SeamFilter& counts = {},
                                       const SheetPlaces& places = {});

/// The point of a line at a part of its length on the garment, from 0 to 1.
/// Precondition: it has points.  Cost: linear in them. Pure.
LineVertex pointAlong(const Scene& scene, const VertexRun& line, double along);

}  // namespace toile::app
