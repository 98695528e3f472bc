// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/mesh/mesh_arrays.h"
#include "core/quality/outline_crossings.h"

namespace toile {

struct Piece;

/// A path along the piece's edges that divides it in two.
struct CrossingCut {
    std::vector<int> path;  ///< piece vertices, from the outline through the inside to the outline
    double length3d = 0;    ///< mm
    bool resolves = false;  ///< neither part's outline, as it lies in Q, crosses itself
};

/// The cut that parts what crosses in a flat outline. Each crossing divides the outline in two
/// arcs; a cut parts the crossing edges where it goes from one of the arcs to the other. Of the
/// shortest such paths (Dijkstra from the places that part all crossings to those opposite, and
/// between places spread over the outline) the shortest is taken that leaves two parts without
/// crossings; among those hardly longer the one that divides the outline most evenly. Where there
/// is none, the one that leaves the fewest crossings: `resolves` is false, one cut is not enough.
/// Nothing where no path leads through the inside. Never along the outline or a hole's rim.
/// @param piece      a disk, holes aside, mm  @param Q  #V x 2
/// @param crossings  from findOutlineCrossings(Q, piece.boundary), not empty
/// @param progress   looked at between the paths and between the tests of cuts; cancelled, the best
///                   so far is returned, untested ones with `resolves` false
/// Cost: linear, and some shortest paths around the places they begin at, no farther than the cut
/// is long, or through the whole piece where nothing short resolves all; and tests of cuts, linear
/// where these are short, else n log n. Fewer of both the larger the piece, so that the worst case
/// is seconds. Of crossings as many as were looked for no cut is said to resolve all.
/// Deterministic. Pure.
std::optional<CrossingCut> cutForCrossings(const Piece& piece, const Points2& Q,
                                           const std::vector<OutlineCrossing>& crossings,
                                           const Progress& progress = Progress());

/// Adds to a note of crossings, if there is one, the cut that resolves them; cancelled, nothing.
/// Cost: as `cutForCrossings`, up to seconds.
void nameCrossingCut(const Piece& piece, const Points2& Q,
                     const std::vector<OutlineCrossing>& crossings, const Progress& progress,
                     Problems& notes);

}  // namespace toile
