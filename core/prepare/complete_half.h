// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "core/io/soup.h"

namespace toile {

/// Half a garment with its mirror image.
struct CompletedHalf {
    PolygonSoup soup;  ///< the half as it was, then the image of each face, in order
    int joined = 0;    ///< positions on the plane, which both halves share
};

/// Completes a garment of which a file has one half. Border positions within the tolerance of the
/// plane move onto it and are shared by both halves, so that no seam is left there; inner ones
/// stay, as cloth that touches the plane from within is not sewn to its image. Images have the
/// names of their faces, with left for right, and the opposite winding; in the UV map they lie next
/// to them, mirrored.
/// @param plane        mm; with unit normal, as in Eigen: normal . x + offset = 0
/// @param tolerance    mm
/// @param millimetres  per unit of the file
/// @return nothing if cloth lies on both sides of the plane by more than the tolerance, or no
///         border lies on it
/// Cost: linear. Pure.
std::optional<CompletedHalf> completeHalf(const PolygonSoup& half,
                                          const Eigen::Hyperplane<double, 3>& plane,
                                          double tolerance, double millimetres);

}  // namespace toile
