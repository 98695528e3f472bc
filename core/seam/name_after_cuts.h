// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/garment/cut_pieces.h"
#include "core/garment/seam.h"

namespace toile {

/// Gives a seam the name of the user's cut that it came of: "inseam"; where a cut left several,
/// "inseam 1", "inseam 2" in the order of the graph; where two cuts run on into one seam, the
/// first cut's name. Names stay unique. Other seams keep theirs.
/// @param pieces  those that the graph was found for, mm
/// Cost: n log n in the points of the cuts, and for each seam its edges times those points of the
/// cuts that are near it in x.
void nameAfterCuts(SeamGraph& graph, const std::vector<std::shared_ptr<const Piece>>& pieces,
                   const std::vector<MadeCut>& cuts);

}  // namespace toile
