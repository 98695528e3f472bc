// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/cut/auto_cut.h"
#include "core/cut/user_cuts.h"
#include "core/garment/piece.h"

namespace toile {

enum class CutAuthor { User, Automatic };

/// A cut that was made in a piece.
struct AppliedCut {
    std::string name;  ///< the user's; "front, automatic cut 1"
    CutAuthor author = CutAuthor::User;
    UserCut::Kind kind = UserCut::Kind::Path;
    std::string piece;  ///< what it opened, by the name before the cut
    double length = 0;  ///< mm, of the line that came open
    CutId id{};
    Wording evidence{};                     ///< of one that Toile proposed: what speaks for it
    std::vector<Eigen::Vector3d> points{};  ///< its line in the piece that it opened, mm
};

/// A cut that Toile would make, and why.
struct ProposedCut {
    UserCut cut;  ///< mm
    Wording evidence{};
};

/// What would be cut in one piece, and what comes of it.
struct ProposedCuts {
    std::vector<ProposedCut> cuts{};
    /// What a part that the cuts leave is called: "front"; empty: by number. Null: all by number.
    std::function<std::string(const Piece&)> nameOf{};
};

/// Proposes cuts for pieces that cannot lie flat, or not well; none where it has no better idea
/// than the shortest. The same for the same piece and the same cuts.
struct CutProposer {
    /// @param own  cuts that are made in the piece anyhow
    std::function<ProposedCuts(const std::shared_ptr<const Piece>&, const std::vector<UserCut>& own,
                               const Progress&)>
        propose{};
    /// A path of edges, from outline to outline, that divides a disk whose flat outline would cross
    /// itself. Empty if none is needed or helps. Null: no disk is checked.
    std::function<std::vector<int>(const Piece&, const Progress&)> partCrossing{};
    int way = 1;              ///< tells it from others that propose otherwise
    bool isForDisks = false;  ///< it is asked about pieces that could lie flat, too
};

/// What was done with one piece that was to be cut.
struct CutRecord {
    std::shared_ptr<const Piece> whole;
    std::vector<UserCut> asked;
    bool automatic = false;
    int proposer = 0;         ///< its `way`; 0: no proposals were asked for
    bool namesPiece = false;  ///< proposed cuts are called by their piece, too
    Pieces pieces{};
    std::vector<AppliedCut> cuts{};
    Problems problems{};
};

/// Pieces after cutting, and what was done.
struct CutPieces {
    Pieces pieces;
    std::vector<AppliedCut> cuts;
    Problems problems;  ///< CutImpossible, for each cut of the user's that could not be made
    std::vector<CutRecord> records;  ///< of those pieces that were to be cut
};

/// Makes the user's cuts, each in the piece that lies nearest to its points, and then, where asked,
/// those that make a disk of every piece that is none: first what is proposed for it, where the
/// user's own leave anything closed (of disks, too, where the proposer is for them), then what
/// still is needed (`proposeCuts`). Then disks are parted until no flat outline would cross itself
/// (`CutProposer::partCrossing`), by a few cuts a piece at most. Of proposals those that cannot be
/// made are left out, and all of them where they leave a part that no cut opens. A piece that comes
/// apart is named by who proposed its cuts, "leggings, left leg", or numbered: "leggings 1",
/// "leggings 2". A piece without cuts is handed on as it is, by pointer. A cut that fails leaves
/// the others, and its piece, alone; a piece that no automatic cut opens keeps its defect, with the
/// reason. Cost: the cuts'; nothing for the pieces without.
/// @param progress  reported; once it is cancelled, what is returned is worth nothing
/// @param proposer  where there is one; a closed piece without cuts of the user's for which it has
///                  nothing is noted (NoBodySeen)
/// @param before    what an earlier call did: where the same is asked of the same piece, the same
///                  parts come of it, by pointer
/// Deterministic. Re-entrant.
CutPieces cutPieces(const Pieces& uncut, std::vector<UserCut> cuts, bool automatic,
                    const Progress& progress, const std::vector<CutRecord>& before = {},
                    const CutProposer& proposer = {});

}  // namespace toile
