// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "app/render/camera.h"
#include "app/render/scene.h"

namespace toile::app {

/// A place on the cloth under the pointer.
struct SurfaceHit {
    int piece = -1;
    int face = -1;  ///< of the piece's mesh
    /// Weights of the face's corners.
    Eigen::Vector3d barycentric = Eigen::Vector3d::Constant(1.0 / 3);
    double distance = 0;  ///< from the ray's origin, mm; 0 in the pattern
};

/// The nearest triangle along the ray, from either side; the first of equals. Searches the pieces'
/// trees: microseconds, even with a million triangles.
/// @param places  hidden pieces are skipped, also in the picks below; empty: all are visible
std::optional<SurfaceHit> pickGarment(const Scene& scene, const Ray& ray,
                                      const SheetPlaces& places = {});

/// The place of the flat piece at a point of the sheet (mm); the topmost if several overlap.
std::optional<SurfaceHit> pickPattern(const Scene& scene, const SheetPlaces& places,
                                      const Eigen::Vector2d& point);

/// The place on one flat piece at a point in its own coordinates.
std::optional<SurfaceHit> pickPiece(const Scene& scene, int piece, const Eigen::Vector2d& point);

/// Converts a place on a piece to a position relative to Scene::origin, or to the flat piece's own
/// coordinates. Precondition: the face is of the piece's mesh.
Eigen::Vector3d garmentPoint(const Scene& scene, int piece, int face,
                             const Eigen::Vector3d& barycentric);
Eigen::Vector2d patternPoint(const Scene& scene, int piece, int face,
                             const Eigen::Vector3d& barycentric);

/// A seam under the pointer.
struct SeamHit {
    int seam = -1;        ///< index into Scene::seams
    int side = 0;         ///< 0 left, 1 right
    int segment = 0;      ///< index in the side's polyline
    double distance = 0;  ///< mm in the pattern; share of the depth in the garment
    double along = 0;     ///< position along the side, as a share of its length on the garment
};

/// Selects the seams that can be hit; an empty filter accepts all.
using SeamFilter = std::function<bool(int seam)>;

/// The seam nearest to a point of the sheet within `radius` mm; the first of equals. Cost: a box
/// per seam, and the segments of the near ones. Pure.
std::optional<SeamHit> pickPatternSeam(const Scene& scene, const SheetPlaces& places,
                                       const Eigen::Vector2d& point, double radius,
                                       const SeamFilter& counts = {});

/// The seam nearest to a ray.
/// @param slope     maximum distance from the ray per mm of depth
/// @param farthest  seams deeper than this along the ray are ignored as hidden, mm
std::optional<SeamHit> pickGarmentSeam(const Scene& scene, const Ray& ray, double slope,
                                       double farthest, const SeamFilter& counts = {},
                                       const SheetPlaces& places = {});

/// The point at a share of a line's length on the garment, from 0 to 1.
/// Precondition: the line has points. Cost: linear in them. Pure.
LineVertex pointAlong(const Scene& scene, const VertexRun& line, double along);

}  // namespace toile::app
