// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/garment/cut_pieces.h"
#include "core/garment/join_pieces.h"
#include "core/garment/seam.h"

namespace toile {

/// A point of a cut lies on the outline but for rounding: this part of the edge's length.
inline constexpr double kOnLine = 1e-6;

/// True where a point lies on the left side of a seam, which is no free edge. @param piece  of that
/// side
bool runsThrough(const Seam& seam, const Piece& piece, const Eigen::Vector3d& point);

/// True where a cut left this seam. @param pieces  those that the seam was found for, mm
/// Cost: the points of the cut times the edges of the seam.
bool isLeftBy(const Seam& seam, const MadeCut& cut,
              const std::vector<std::shared_ptr<const Piece>>& pieces);

/// The order that takes a seam out which the garment's own division made: points along its left
/// side, mm, its ends among them.
UserJoin joinAlong(const Seam& seam, const std::vector<std::shared_ptr<const Piece>>& pieces);

/// Gives a seam the name of the user's cut that it came of: "inseam"; where a cut left several,
/// "inseam 1", "inseam 2" in the order of the graph; where two cuts run on into one seam, the
/// first cut's name. Names stay unique. Other seams keep theirs.
/// @param pieces  those that the graph was found for, mm
/// Cost: n log n in the points of the cuts, and for each seam its edges times those points of the
/// cuts that are near it in x.
void nameAfterCuts(SeamGraph& graph, const std::vector<std::shared_ptr<const Piece>>& pieces,
                   const std::vector<MadeCut>& cuts);

}  // namespace toile
