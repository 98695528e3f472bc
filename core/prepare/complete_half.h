// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "core/io/soup.h"

namespace toile {

/// Half a garment and its mirror image.
struct CompletedHalf {
    PolygonSoup soup;  ///< the half as it was, then the image of each face, in order
    int joined = 0;    ///< positions on the plane, which both halves share
};

/// Completes a garment of which a file has one half. Border positions within the tolerance of the
/// plane move onto it, and both halves share them, so that no seam is left there; inner ones stay,
/// as cloth that touches the plane from within is not sewn to its image. Images have the names of
/// their faces, with left for right, and run the other way around; in the UV map they lie beside
/// them, mirrored.
/// @param plane        mm; of unit normal, as Eigen's: normal . x + offset = 0
/// @param tolerance    mm
/// @param millimetres  per unit of the file
/// @return none where cloth lies on both sides of the plane by more than the tolerance, or no
/// border
///         lies on it
/// Cost: linear. Pure.
std::optional<CompletedHalf> completeHalf(const PolygonSoup& half,
                                          const Eigen::Hyperplane<double, 3>& plane,
                                          double tolerance, double millimetres);

}  // namespace toile
