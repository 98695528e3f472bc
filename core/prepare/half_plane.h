// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/io/conventions.h"
#include "core/prepare/file_surface.h"
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
/// @param isStated the user said that it is half: a short rim is enough, as of one flat panel.
///                 Otherwise they must be a large share of all rims and lie apart, like centre
///                 front and centre back, in two places unless there are other openings
/// @return its normal points at the cloth; nothing if there is no such plane
/// Cost: n log n. Pure.
std::optional<HalfPlane> findHalfPlane(const FileSurface& surface, UpAxis up, bool isStated);

}  // namespace toile
