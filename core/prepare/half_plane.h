// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/io/conventions.h"
#include "core/prepare/file_surface.h"
#include "core/prepare/prepare_file.h"

namespace toile {

/// How far a rim may lie off the plane in which a garment is there by half, mm: a thousandth of the
/// garment's size.
double halfTolerance(const MeshArrays& mesh);

/// Looks for the upright plane in which rims of a garment lie that has all its cloth on one side of
/// it: there its mirror image goes on. The file's own planes through 0 are tried first, x before
/// the other, then those that touch the cloth from outside. An opening that lies in the plane as a
/// whole, as the end of a sleeve, speaks for nothing, unless there is no other rim.
/// @param surface  in the file's axes   @param up  of the file
/// @param isStated a person says that it is half: a short rim is enough, as of one flat panel.
///                 Else they have to be a good part of all rims and to lie apart, as centre front
///                 and centre back do, in two places unless there are openings besides
/// @return its normal points at the cloth; none where there is no such plane
/// Cost: n log n. Pure.
std::optional<HalfPlane> findHalfPlane(const FileSurface& surface, UpAxis up, bool isStated);

}  // namespace toile
