// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/opening_cuts.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/assemble/cut_pieces.h"
#include "core/cut/auto_cut.h"

namespace toile {
namespace {

/// Lines are equal if their lengths differ by no more than this share.
constexpr double kSameLine = 0.01;

/// Which points of a line a cut keeps. The middle point identifies the piece if two meet at both
/// ends, like a lining and its shell.
enum class Kept { EndsAndMiddle, Bends, All };

UserCut cutAlongLine(const Piece& piece, const SurfaceLinks& links, const PathPolyline& line,
                     Kept kept) {
    UserCut cut;
    const std::size_t last = line.points.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
        const bool isOne = i == 0 || i == last || i == (last + 1) / 2;
        const bool isAtVertex = links.carrierOf(line.points[i]).kind == Carrier::Kind::Vertex;
        if (isOne || kept == Kept::All || (kept == Kept::Bends && isAtVertex)) {
            cut.points.push_back(positionOf(piece.mesh, line.points[i]));
        }
    }
    return cut;
}

/// Whether the cuts leave one disk, and follow their original lines.
bool doOpen(const std::shared_ptr<const Piece>& piece, const std::vector<UserCut>& cuts,
            const AutoCut& proposal, const Progress& progress) {
    const CutPieces made = cutPieces({piece}, cuts, false, progress);
    double wanted = 0, opened = 0;
    for (const PathPolyline& line : proposal.cuts) {
        wanted += line.length;
    }
    for (const AppliedCut& cut : made.cuts) {
        opened += cut.length;
    }
    return made.pieces.size() == 1 && !made.pieces.front()->defect && made.problems.empty() &&
           std::abs(opened - wanted) <= kSameLine * wanted;
}

}  // namespace

bool isOpenable(const Piece& piece) {
    constexpr ErrorCode kRepairable[] = {ErrorCode::ClosedSurface, ErrorCode::SeveralLoops,
                                         ErrorCode::Handle};
    return piece.defect &&
           std::ranges::find(kRepairable, piece.defect->code) != std::end(kRepairable);
}

Result<std::vector<UserCut>> openingCuts(const Piece& piece, bool isWhole,
                                         const Progress& progress) {
    const auto proposal = proposeCuts(piece.mesh, piece.table, {}, progress);
    if (!proposal) {
        return proposal.error();
    }
    const SurfaceLinks links(piece.mesh, piece.table);
    const auto alone = std::make_shared<const Piece>(piece);
    for (const Kept kept : {Kept::EndsAndMiddle, Kept::Bends, Kept::All}) {
        if (!isWhole && kept != Kept::All) {
            continue;
        }
        std::vector<UserCut> cuts;
        for (const PathPolyline& line : proposal->cuts) {
            cuts.push_back(cutAlongLine(piece, links, line, kept));
        }
        if (doOpen(alone, cuts, *proposal, progress)) {
            return cuts;
        }
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
    }
    return cutError(subjectOf(piece), worded("no cuts were found that open it"));
}

}  // namespace toile
