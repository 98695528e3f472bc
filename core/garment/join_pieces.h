// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/cut/user_cuts.h"
#include "core/garment/piece.h"

namespace toile {

/// A seam that was taken out.
struct AppliedJoin {
    std::string name;   ///< the user's
    std::string piece;  ///< what came of it: "front + back", or the one piece on both sides
    double length = 0;  ///< mm, of the line that was closed
};

/// Pieces after joining, and what was done.
struct JoinedPieces {
    Pieces pieces;
    std::vector<AppliedJoin> joins;
    Problems problems;  ///< JoinImpossible, for each seam that could not be taken out
};

/// Takes seams out, one after the other: where two rims have the same vertices along the points of
/// a join, the two are made one. The first piece keeps its place in the list, its vertices and its
/// faces their numbers; those of the second follow, less the vertices that became the first's. Both
/// sides may be of one piece: the two edges of a dart, or of a tube. Area, winding and sources are
/// kept; the reference panel is not, since two panels are not one. What comes of it need be no
/// disk: that is then its defect. Pieces without a join are handed on as they are, by pointer.
/// Refused, each with its reason, and nothing else left out for it: points far from any rim; a rim
/// there that has no other one with the same vertices, or more than one; pieces of two files; what
/// would be no surface any more.
/// @param progress  reported; once it is cancelled, what is returned is worth nothing
/// Cost: linear in all triangles, and for every join in those of its two pieces and in the edges of
/// all rims; nothing without joins. Deterministic. Re-entrant.
JoinedPieces joinPieces(const Pieces& uncut, const std::vector<UserJoin>& joins,
                        const Progress& progress = Progress());

}  // namespace toile
