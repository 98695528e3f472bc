// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/garment/garment.h"

// Internal header of this folder.
namespace toile {

/// Replaces pieces by equal ones of an earlier garment, so that data known about them (parts, flat
/// points) stays valid. Cost: linear in the meshes.
void reusePieces(Pieces& pieces, const Garment& before);

}  // namespace toile
