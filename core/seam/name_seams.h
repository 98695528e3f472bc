// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/garment/piece.h"
#include "core/garment/seam.h"
#include "core/seam/outline.h"

namespace toile {

/// Orders seams (sewn ones first; by piece, kind, then place in space) and names them.
void orderAndName(const std::vector<std::shared_ptr<const Piece>>& pieces, const Outlines& outlines,
                  std::vector<Seam>& seams);

}  // namespace toile
