// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "core/garment/piece.h"
#include "core/pipeline/file_space.h"
#include "core/pipeline/pipeline.h"
#include "core/quality/measures.h"
#include "core/seam/find_seams.h"
#include "core/seam/seam_origin.h"

namespace toile {
namespace {

/// Of the time, about; the rest is finding the seams.
constexpr double kJoiningShare = 0.1;
constexpr double kCuttingShare = 0.6;

/// A hole is no fault, but most methods change the length of its rim, and that is to be said.
void noteHoles(Garment& garment) {
    for (const auto& piece : garment.pieces) {
        if (!piece->holes.empty()) {
            double longest = 0;
            for (const auto& hole : piece->holes) {
                longest = std::max(longest, boundaryLengths3d(piece->mesh.V, hole).sum());
            }
            const auto count = static_cast<long long>(piece->holes.size());
            const std::vector<Wording> words{countWording(count, "hole"), figure(longest, 1)};
            garment.problems.push_back({ErrorCode::HolesKept, piece->name,
                                        count > 1 ? worded("%1, the longest rim %2 mm", words)
                                                  : worded("%1, its rim %2 mm", words)});
        }
    }
}

void setEase(Garment& garment, const SeamsFile& seams) {
    std::unordered_map<std::string_view, Seam*> byName;
    for (Seam& seam : garment.seams.seams) {
        byName.emplace(seam.name, &seam);
    }
    std::vector<std::string> unknown;
    for (const auto& [name, ease] : seams.ease) {
        const auto seam = byName.find(name);
        if (seam == byName.end() || seam->second->kind == SeamKind::Free) {
            unknown.push_back(name);
        } else {
            seam->second->ease = ease;
        }
    }
    const Problems problems =
        aboutEach(ErrorCode::NoSuchSeam, unknown, worded("the seams file gives it an ease"));
    garment.problems.insert(garment.problems.end(), problems.begin(), problems.end());
}

/// Cuts and joins are made anew each time; what comes out as it was before is the same piece, so
/// that what is known of it (flat points, a place) stays.
void keepUnchanged(std::vector<std::shared_ptr<const Piece>>& pieces,
                   const std::vector<std::shared_ptr<const Piece>>& before) {
    std::unordered_map<std::string_view, const std::shared_ptr<const Piece>*> byName;
    for (const auto& piece : before) {
        byName.emplace(piece->name, &piece);
    }
    for (auto& piece : pieces) {
        const auto known = byName.find(piece->name);
        if (known != byName.end() && isSamePiece(*piece, **known->second)) {
            piece = *known->second;
        }
    }
}

}  // namespace

Result<Garment> cutGarment(const Garment& garment, const LoadOptions& options,
                           const Progress& progress) {
    Garment made;
    made.files = garment.files;
    made.wholes = garment.wholes;
    JoinedPieces joined = joinPieces(garment.wholes, joinsInPieceSpace(options.seams, garment),
                                     Progress(progress, kJoiningShare));
    progress.report(kJoiningShare);
    CutPieces cut = cutPieces(joined.pieces, cutsInPieceSpace(options.seams, garment),
                              options.autoCut, Progress(progress, kCuttingShare));
    progress.report(kJoiningShare + kCuttingShare);
    made.pieces = std::move(cut.pieces);
    keepUnchanged(made.pieces, garment.pieces);
    made.cuts = std::move(cut.cuts);
    made.joins = std::move(joined.joins);
    made.problems = std::move(joined.problems);
    made.problems.insert(made.problems.end(), cut.problems.begin(), cut.problems.end());
    noteHoles(made);
    made.seams = findSeams(made.pieces, {}, Progress(progress, 1 - kJoiningShare - kCuttingShare));
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, "", ""};
    }
    made.problems.insert(made.problems.end(), made.seams.notes.begin(), made.seams.notes.end());
    nameAfterCuts(made.seams, made.pieces, made.cuts);
    setEase(made, options.seams);
    progress.report(1);
    return made;
}

}  // namespace toile
