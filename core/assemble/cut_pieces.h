// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cut/auto_cut.h"
#include "core/cut/user_cuts.h"
#include "core/garment/piece.h"
#include "core/garment/records.h"

namespace toile {

/// A cut proposed by Toile, with its reasons.
struct ProposedCut {
    UserCut cut;  ///< mm
    Wording evidence{};
};

/// Proposed cuts of one piece, and the names of its parts.
struct ProposedCuts {
    std::vector<ProposedCut> cuts{};
    /// The name of a part after the cuts: "front"; empty: a number. Null: numbers for all.
    std::function<std::string(const Piece&)> nameOf{};
};

/// Proposes cuts for pieces that cannot lie flat, or not well; none if it has no better idea than
/// the shortest. Deterministic for the same piece and the same cuts.
struct CutProposer {
    /// @param own  cuts made in the piece in any case
    std::function<ProposedCuts(const std::shared_ptr<const Piece>&, const std::vector<UserCut>& own,
                               const Progress&)>
        propose{};
    /// A path of edges, from outline to outline, that divides a disk whose flat outline would cross
    /// itself. Empty if no cut is needed or helps. Null: disks are not checked.
    std::function<std::vector<int>(const Piece&, const Progress&)> partCrossing{};
    int way = 1;              ///< identifies this kind of proposals
    bool isForDisks = false;  ///< called for pieces that can lie flat, too
};

/// Pieces after cutting, with records.
struct CutPieces {
    Pieces pieces;
    std::vector<AppliedCut> cuts;
    Problems problems;               ///< CutImpossible, for each cut of the user that failed
    std::vector<CutRecord> records;  ///< of pieces with cuts or proposals
};

/// Makes the user's cuts, each in the piece closest to its points. If requested, it then opens
/// every piece that is not a disk: first by the proposed cuts, if the user's own leave a part
/// closed (for disks, too, if the proposer is for them), then by the cuts still needed
/// (`proposeCuts`). Finally it divides disks until no flat outline would cross itself
/// (`CutProposer::partCrossing`), by a few cuts per piece at most. Proposed cuts that fail are
/// omitted, and all of them if they leave a part that no cut opens. Parts are named by the
/// proposer, "leggings, left leg", or numbered: "leggings 1", "leggings 2". A piece without cuts is
/// returned by the same pointer. A failed cut does not affect other cuts or its piece; a piece that
/// no automatic cut opens keeps its defect, with the reason. Cost: that of the cuts; nothing for
/// the other pieces.
/// @param progress  reported; after a cancel the result is meaningless
/// @param proposer  may be null; a closed piece without cuts of the user for which it proposes
///                  nothing is noted (NoBodySeen)
/// @param before    the result of an earlier call: the same cuts of the same piece return the same
///                  parts, by pointer
/// Deterministic. Re-entrant.
CutPieces cutPieces(const Pieces& uncut, std::vector<UserCut> cuts, bool automatic,
                    const Progress& progress, const std::vector<CutRecord>& before = {},
                    const CutProposer& proposer = {});

/// Whether a piece cannot lie flat for a reason that cuts can solve.
bool isOpenable(const Piece& piece);

/// The automatic cuts (`proposeCuts`) that open one piece, as if the user had drawn them, so that
/// they can be kept, moved and removed like any other; `cutPieces` would open all pieces that
/// cannot lie flat. Each has few points if the shortest paths between these follow the same lines.
/// @param isWhole  the piece is as divided and joined; a piece made by other cuts keeps all points
///                 of the lines, since cuts are drawn on the surface before them
/// @return  in mm, without names and ids; applied to the piece they leave one disk
/// @errors  those of `proposeCuts`; a cut error if no cuts achieve that; Cancelled
/// Cost: that of the cuts, up to three times. Deterministic. Re-entrant.
Result<std::vector<UserCut>> openingCuts(const Piece& piece, bool isWhole,
                                         const Progress& progress = Progress());

}  // namespace toile
