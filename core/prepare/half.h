// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "core/io/conventions.h"
#include "core/io/soup.h"
#include "core/prepare/file_surface.h"
#include "core/prepare/preparation.h"
#include "core/prepare/prepare_file.h"

namespace toile {

/// How far a rim may lie off the mirror plane of half a garment, mm: a thousandth of the garment's
/// size.
double halfTolerance(const MeshArrays& mesh);

/// Looks for a vertical plane that contains rims of a garment with all its cloth on one side: the
/// mirror plane of half a garment. The file's own planes through 0 are tried first, x before the
/// other, then those that touch the cloth from outside. An opening entirely within the plane, like
/// the end of a sleeve, is no evidence unless there is no other rim.
/// @param surface  in the file's axes   @param up  of the file
/// @param isStated the user stated that it is half: a short rim is enough, as of one flat panel.
///                 Otherwise they must be a large share of all rims and lie apart, like centre
///                 front and centre back, in two places unless there are other openings
/// @return its normal points at the cloth; nothing if there is no such plane
/// Cost: n log n. Pure.
std::optional<HalfPlane> findHalfPlane(const FileSurface& surface, UpAxis up, bool isStated);

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

/// Tests whether a file holds half a garment (`findHalfPlane`), and adds its mirror image if the
/// user stated so. The plane found is stored in the file's reading, the change in its problems:
/// ReadAs; CannotReadAs if there is no mirror plane.
/// @param file  after the other preparation  @param millimetres  per unit of the file
/// @param name  of the file, for the notes
/// Cost: n log n. Pure.
void takeHalf(PreparedFile& file, const Preparation& preparation, UpAxis up, double millimetres,
              const std::string& name);

}  // namespace toile
