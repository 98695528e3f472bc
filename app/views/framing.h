// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>

#include "app/render/camera_2d.h"
#include "app/render/camera_3d.h"
#include "app/render/morph.h"

namespace toile {

/// How the views, and pictures of them, bring pieces into sight. Pieces are indices into
/// Scene::pieces; the cameras' viewports are set before.

/// The state of the morph before this camera: the sheet stands upright in front of it.
/// @param scene  may be null
Morph morphBefore(const Camera3D& camera, const Scene* scene, double way);

/// @param pieces  never empty
/// @param way  of the morph
void frameGarment(Camera3D& camera, const Scene& scene, const SheetPlaces& places,
                  const std::set<int>& pieces, double way);

/// Room for what is written around the pattern.
Camera2D::Margins patternMargins(bool rulers);

void framePattern(Camera2D& camera, const Scene& scene, const SheetPlaces& places,
                  const std::set<int>& pieces, bool rulers);

}  // namespace toile
