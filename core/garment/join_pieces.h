// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/cut/user_cuts.h"
#include "core/garment/piece.h"
#include "core/garment/records.h"

namespace toile {

/// Pieces after joining, with records.
struct JoinedPieces {
    Pieces pieces;
    std::vector<AppliedJoin> joins;
    Problems problems;  ///< JoinImpossible, for each seam that could not be removed
};

/// Removes seams one after the other: if two rims have the same vertices along the points of a
/// join, they are merged. The first piece keeps its position in the list, its vertices and faces
/// their indices; those of the second follow, without the merged vertices. Both sides may belong to
/// one piece: the two edges of a dart, or of a tube. Area, winding and sources are kept; the
/// reference panel is dropped, since two panels are not one. If the result is not a disk, it gets a
/// defect. Pieces without a join are returned by the same pointer.
/// Rejected, each with its reason, without affecting other joins: points far from any rim; a rim
/// there without exactly one other rim that has the same vertices; pieces of two files; results
/// that would not be a surface.
/// @param progress  reported; after a cancel the result is meaningless
/// Cost: linear in all triangles, and for every join in those of its two pieces and in the edges of
/// all rims; nothing without joins. Deterministic. Re-entrant.
JoinedPieces joinPieces(const Pieces& uncut, const std::vector<UserJoin>& joins,
                        const Progress& progress = Progress());

}  // namespace toile
