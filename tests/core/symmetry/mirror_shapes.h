// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "core/garment/garment.h"

namespace toile::test {

/// Where a point of a garment is put.
using Motion = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/// A tapered tube of four panels, in this order: "front", "left", "back", "right"; the mirror image
/// of itself in x = 0 and in no other plane. 416 vertices, sewn where the panels meet.
/// @param leftRows  squares along the left panel's height; the right one has 12
Garment tube4(const Motion& motion = {}, int leftRows = 12);

/// Pushes a garment as cloth that hangs is: a few millimetres, smoothly, with no symmetry.
Eigen::Vector3d draped(const Eigen::Vector3d& p);

/// A turn about a slanting axis and a shift.
Eigen::Vector3d moved(const Eigen::Vector3d& p);
/// The turn alone, of a direction.
Eigen::Vector3d turned(const Eigen::Vector3d& direction);

/// The same pieces in the opposite order, sewn anew.
Garment inOppositeOrder(const Garment& garment);

/// A garment of the samples or of the shared ones; empty where it cannot be read, and the test
/// fails.
Garment garmentOf(const std::string& file);

}  // namespace toile::test
