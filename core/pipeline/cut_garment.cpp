// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "core/garment/file_space.h"
#include "core/garment/piece.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/reuse_pieces.h"
#include "core/quality/measures.h"
#include "core/seam/find_seams.h"
#include "core/seam/mirror_seams.h"
#include "core/seam/seam_origin.h"
#include "core/seam/seam_settings.h"
#include "core/tailor/tailor_cuts.h"

namespace toile {
namespace {

/// Of the time, about; the rest is finding the seams.
constexpr double kJoiningShare = 0.1;
constexpr double kCuttingShare = 0.6;
/// From here on a line of the mesh is named as the reason for a cut.
constexpr double kSeamLikely = 0.6;

/// What tailors would cut.
std::vector<ProposedCut> proposedFor(const std::shared_ptr<const Piece>& piece,
                                     const Progress& progress) {
    std::vector<ProposedCut> cuts;
    for (TailorCut& cut : tailorCuts(piece, progress)) {
        Wording evidence = cut.likeliness > kSeamLikely
                               ? worded("the mesh has a line there that looks like a seam (%1)",
                                        {figure(cut.likeliness, 2)})
                               : worded("by the form");
        cuts.push_back({std::move(cut.cut), std::move(evidence)});
    }
    return cuts;
}

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
            garment.problems.push_back({ErrorCode::HolesKept, subjectOf(*piece),
                                        count > 1 ? worded("%1, the longest rim %2 mm", words)
                                                  : worded("%1, its rim %2 mm", words)});
        }
    }
}

}  // namespace

LoadOptions resolveNames(LoadOptions options, const Garment& garment) {
    options.seamSettings = garment.seamSettings;
    options.seams.ease.clear();
    giveIds(options.seams.cuts);
    return options;
}

std::optional<Garment> easedGarment(const Garment& garment,
                                    const std::vector<SeamSettings>& settings) {
    const auto isNamed = [](const SeamSettings& said) { return !said.name.empty(); };
    if (std::ranges::any_of(settings, isNamed) ||
        std::ranges::any_of(garment.seamSettings, isNamed)) {
        return std::nullopt;
    }
    Garment eased = garment;
    for (Seam& seam : eased.seams.seams) {
        seam.ease.reset();
        seam.drawn.reset();
    }
    eased.seamSettings = settings;
    applySettings(eased.seams, settings);
    return eased;
}

Result<Garment> cutGarment(const Garment& garment, const LoadOptions& options,
                           const Progress& progress) {
    Garment made;
    made.files = garment.files;
    made.uncut = garment.uncut;
    SeamsFile seams = options.seams;
    giveIds(seams.cuts);
    JoinedPieces joined = joinPieces(garment.uncut, joinsInPieceSpace(seams, garment),
                                     Progress(progress, kJoiningShare));
    reusePieces(joined.pieces, garment);
    progress.report(kJoiningShare);
    const ProposeCuts propose =
        options.cutStyle == CutStyle::Topology ? ProposeCuts() : ProposeCuts(proposedFor);
    CutPieces cut = cutPieces(joined.pieces, cutsInPieceSpace(seams, garment), options.autoCut,
                              Progress(progress, kCuttingShare), garment.cutRecords, propose);
    progress.report(kJoiningShare + kCuttingShare);
    made.pieces = std::move(cut.pieces);
    made.cuts = std::move(cut.cuts);
    made.cutRecords = std::move(cut.records);
    made.joins = std::move(joined.joins);
    made.problems = std::move(joined.problems);
    made.problems.insert(made.problems.end(), cut.problems.begin(), cut.problems.end());
    noteHoles(made);
    made.seams = findSeams(made.pieces, {}, Progress(progress, 1 - kJoiningShare - kCuttingShare));
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    made.problems.insert(made.problems.end(), made.seams.notes.begin(), made.seams.notes.end());
    nameAfterCuts(made.seams, made.cuts);
    nameMirrorSeams(made.seams, made);
    made.seamSettings = withEaseByName(options.seamSettings, made.seams, seams.ease, made.problems);
    applySettings(made.seams, made.seamSettings);
    progress.report(1);
    return made;
}

}  // namespace toile
