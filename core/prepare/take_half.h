// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/io/conventions.h"
#include "core/prepare/preparation.h"
#include "core/prepare/prepare_file.h"

namespace toile {

/// Sees whether a file holds half a garment (`findHalfPlane`), and adds its mirror image where a
/// person says that it does. What was found stands in the file's reading, what was done in its
/// problems: ReadAs; CannotReadAs where there is no plane to mirror it in.
/// @param file  as prepared otherwise  @param millimetres  per unit of the file
/// @param name  of the file, for the notes
/// Cost: n log n. Pure.
void takeHalf(PreparedFile& file, const Preparation& preparation, UpAxis up, double millimetres,
              const std::string& name);

}  // namespace toile
