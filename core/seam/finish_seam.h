// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/garment/piece.h"
#include "core/garment/seam.h"
#include "core/seam/choose_runs.h"
#include "core/seam/outline.h"

namespace toile {

/// Makes a seam of a run: decides the kind, puts its ends on vertices that are near enough, and
/// writes down the corresponding places. No name yet.
Seam finishSeam(const Outlines& outlines, const Chosen& chosen);

/// A seam of one side: an edge sewn to nothing.
/// @param index  of the outline
Seam freeEdge(const Outlines& outlines, int index, Arc arc);

/// Orders seams (sewn ones first; by piece, kind, then place in space) and names them.
void orderAndName(const std::vector<std::shared_ptr<const Piece>>& pieces, const Outlines& outlines,
                  std::vector<Seam>& seams);

}  // namespace toile
