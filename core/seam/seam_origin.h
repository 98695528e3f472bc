// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/garment/cut_pieces.h"
#include "core/garment/join_pieces.h"
#include "core/garment/seam.h"
#include "core/seam/outline.h"

namespace toile {

/// Where a stretch of outline comes from: the line that most of it is of. No line where none is
/// known. @param side  along `outline`, which is one of the piece  Cost: its edges. Pure.
LineStretch stretchOf(const SeamSide& side, const seam::Outline& outline, const Piece& piece);

/// The parts of an outline, as arc lengths in mm, that come of a stretch, in its order, none of
/// which goes on in the next. The one across the outline's first vertex is in two. Cost: the
/// outline's edges. Pure.
std::vector<geometry::Interval> partsOf(const LineStretch& stretch, const seam::Outline& outline,
                                        const Piece& piece);

/// Writes down, for every seam and free edge, where its two sides come from, and gives it an id.
/// Cost: linear in the edges of the seams, times the logarithm of the outlines'.
void traceOrigins(const std::vector<std::shared_ptr<const Piece>>& pieces,
                  const seam::Outlines& outlines, std::vector<Seam>& seams);

/// The order that takes a seam out which the garment's own division made: points along its left
/// side, mm, its ends among them.
UserJoin joinAlong(const Seam& seam, const std::vector<std::shared_ptr<const Piece>>& pieces);

/// Gives a seam the name of the user's or the tailor's cut it came of: "inseam"; of several,
/// "inseam 1", "inseam 2" in the order of the graph; where two cuts run on into one seam, the
/// first cut's name. Names stay unique. Other seams keep theirs. n log n.
void nameAfterCuts(SeamGraph& graph, const std::vector<AppliedCut>& cuts);

}  // namespace toile
