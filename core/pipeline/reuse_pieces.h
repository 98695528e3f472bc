// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/garment/garment.h"

// For the sources of this folder only.
namespace toile {

/// Puts the pieces of an earlier garment in the place of those that came out the same, so that what
/// is known of them (their parts, flat points) stays. Cost: linear in the meshes.
void reusePieces(std::vector<std::shared_ptr<const Piece>>& pieces, const Garment& before);

}  // namespace toile
