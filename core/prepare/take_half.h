// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/io/conventions.h"
#include "core/prepare/preparation.h"
#include "core/prepare/prepare_file.h"

namespace toile {

/// Tests whether a file holds half a garment (`findHalfPlane`), and adds its mirror image if the
/// user said so. The plane found is stored in the file's reading, the change in its problems:
/// ReadAs; CannotReadAs if there is no mirror plane.
/// @param file  after the other preparation  @param millimetres  per unit of the file
/// @param name  of the file, for the notes
/// Cost: n log n. Pure.
void takeHalf(PreparedFile& file, const Preparation& preparation, UpAxis up, double millimetres,
              const std::string& name);

}  // namespace toile
