// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <vector>

#include "app/render/camera.h"
#include "app/render/scene.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::app {

/// The way from the garment to the pattern, 0 to 1, as the garment view shows it: in the first half
/// every flat piece flattens where it is worn, in the second it flies to its place on the sheet.
/// The sheet stands upright before the eye.
struct Morph {
    double way = 0;
    Eigen::Matrix3d sheetAxes = Eigen::Matrix3d::Identity();  ///< columns: x, y, towards the eye
    Eigen::Vector3d sheetCentre = Eigen::Vector3d::Zero();    ///< where the sheet's middle stands

    /// How flat the cloth is, 0 to 1, and how far pieces have flown.
    double bend() const;
    double flight() const;

    bool operator==(const Morph&) const = default;
};

/// The motion that brings the flat points nearest to the worn ones (least squares), without
/// turning over. Cost: linear. Pure.
SpaceMotion bestRest(const Points2& flat, const Points3& worn, const Eigen::Vector3d& origin);

/// Where each flat piece lies in space on that way, once it is flat: turning evenly, about its
/// middle. Cost: linear in the pieces. Pure.
std::vector<SpaceMotion> morphMotions(const Scene& scene, const SheetPlaces& places,
                                      const Morph& morph);

/// A worn point on the way. @param motion of its piece, from `morphMotions`
Eigen::Vector3d morphed(const Morph& morph, const SpaceMotion& motion, const Eigen::Vector3d& worn,
                        const Eigen::Vector2d& flat);

/// Around everything that is shown on the way, for framing: pieces that are not flat stay where
/// they are.
std::vector<Eigen::AlignedBox3d> morphBoxes(const Scene& scene, const SheetPlaces& places,
                                            const Morph& morph);

/// The state of the morph before this camera: the sheet stands upright in front of it.
/// @param scene  may be null
Morph morphBefore(const Camera3D& camera, const Scene* scene, double way);

/// Brings pieces into sight, in the view and in pictures of it. The camera's viewport is set
/// before.
/// @param pieces  indices into Scene::pieces, never empty
/// @param way  of the morph
void frameGarment(Camera3D& camera, const Scene& scene, const SheetPlaces& places,
                  const std::set<int>& pieces, double way);

}  // namespace toile::app
