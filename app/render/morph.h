// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <vector>

#include "app/render/camera.h"
#include "app/render/scene.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::app {

/// The morph from garment (0) to pattern (1). In the first half, every flat piece flattens in
/// place. In the second, it flies to its place on the sheet, which faces the eye upright.
struct Morph {
    double way = 0;
    Eigen::Matrix3d sheetAxes = Eigen::Matrix3d::Identity();  ///< columns: x, y, towards the eye
    Eigen::Vector3d sheetCentre = Eigen::Vector3d::Zero();    ///< position of the sheet's middle

    /// Flatness of the cloth, 0 to 1, and progress of the flight.
    double bend() const;
    double flight() const;

    bool operator==(const Morph&) const = default;
};

/// The rigid motion, without mirroring, that brings flat points nearest to worn ones in the least
/// squares sense. Cost: linear. Pure.
SpaceMotion bestRest(const Points2& flat, const Points3& worn, const Eigen::Vector3d& origin);

/// The rigid motion of each flat piece at this state, rotating evenly around its middle. Cost:
/// linear in the pieces. Pure.
std::vector<SpaceMotion> morphMotions(const Scene& scene, const SheetPlaces& places,
                                      const Morph& morph);

/// A worn point during the morph. @param motion of its piece, from `morphMotions`
Eigen::Vector3d morphed(const Morph& morph, const SpaceMotion& motion, const Eigen::Vector3d& worn,
                        const Eigen::Vector2d& flat);

/// Boxes of everything shown during the morph, for framing. Pieces that are not flat stay in place.
std::vector<Eigen::AlignedBox3d> morphBoxes(const Scene& scene, const SheetPlaces& places,
                                            const Morph& morph);

/// The morph's state for this camera: the sheet faces it upright.
/// @param scene  may be null
Morph morphBefore(const Camera3D& camera, const Scene* scene, double way);

/// Frames pieces, in the view and in pictures of it. Precondition: the camera's viewport is set.
/// @param pieces  indices into Scene::pieces, never empty
/// @param way  of the morph
void frameGarment(Camera3D& camera, const Scene& scene, const SheetPlaces& places,
                  const std::set<int>& pieces, double way);

}  // namespace toile::app
