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
    bool resolves = false;  ///< the outline of neither part crosses itself in Q
    double folded3d = 0;    ///< mm of outline between the crossing edges, on the shorter side

    /// Whether the cut is shorter than the stretches that it frees. If not, corners of a ragged
    /// edge fold over, and a cut would take off a strip without need.
    bool isWorthIt() const { return length3d <= folded3d; }
};

/// Finds the cut that separates the crossing edges of a flat outline. Each crossing divides the
/// outline in two arcs; a cut separates its edges if it goes from one arc to the other. Candidates
/// are shortest paths (Dijkstra between opposite places that separate all crossings, and between
/// places spread over the outline). The result is the shortest that leaves two parts without
/// crossings, or a slightly longer one that divides the outline more evenly. If there is none, it
/// is the path that leaves the fewest crossings; then `resolves` is false: one cut is not enough.
/// Nothing if no path leads through the inside. Never along the outline or a hole's rim.
/// @param piece      a disk, holes aside, mm  @param Q  #V x 2
/// @param crossings  from findOutlineCrossings(Q, piece.boundary), not empty
/// @param progress   polled between paths and between tests of cuts; after a cancel the best so far
///                   is returned, untested cuts with `resolves` false
/// Cost: linear, plus some shortest paths around their sources up to the length of the cut, or
/// through the whole piece if no short cut resolves all; plus tests of cuts, linear for short cuts,
/// else n log n. Larger pieces get fewer of both, so that the worst case is seconds. If the number
/// of crossings reached its limit, `resolves` is always false.
/// Deterministic. Pure.
std::optional<CrossingCut> cutForCrossings(const Piece& piece, const Points2& Q,
                                           const std::vector<OutlineCrossing>& crossings,
                                           const Progress& progress = Progress());

/// Adds the cut that resolves the crossings to the note about them, if there is one; nothing after
/// a cancel. Cost: as `cutForCrossings`, up to seconds.
void nameCrossingCut(const Piece& piece, const Points2& Q,
                     const std::vector<OutlineCrossing>& crossings, const Progress& progress,
                     Problems& notes);

}  // namespace toile
