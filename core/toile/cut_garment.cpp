// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "core/assemble/cut_pieces.h"
#include "core/assemble/file_space.h"
#include "core/assemble/join_pieces.h"
#include "core/diagnose/crossing_cut.h"
#include "core/diagnose/doubt.h"
#include "core/flatten/flatten.h"
#include "core/garment/piece.h"
#include "core/quality/measures.h"
#include "core/seam/find_seams.h"
#include "core/seam/seam_settings.h"
#include "core/tailor/cut_advice.h"
#include "core/tailor/mesh_lines.h"
#include "core/toile/garment_flattener.h"
#include "core/toile/pipeline.h"

namespace toile {
namespace {

/// Approximate shares of the time; finding the seams takes the rest.
constexpr double kJoiningShare = 0.1;
constexpr double kCuttingShare = 0.6;

/// The cut that a piece needs because its flat outline crosses itself, or can only be moved apart
/// with more strain than any cloth takes. `Method::Curvature` is much faster, and its outline is
/// the first to cross itself, so it is tried first.
std::vector<int> cutOfCrossings(const Piece& piece, const Progress& progress) {
    const auto quick = flatten(piece, {Method::Curvature}, progress);
    if (!quick || quick->crossings.empty()) {
        return {};
    }
    FlattenOptions draft;
    draft.quality = Quality::Draft;
    const auto flat = flatten(piece, draft, progress);
    if (!flat || (flat->crossings.empty() && flat->apartStrain <= kApartStrain)) {
        return {};
    }
    const FlatPiece& crossing = flat->crossings.empty() ? *quick : *flat;
    const auto cut = cutForCrossings(piece, crossing.Q, crossing.crossings, progress);
    return cut && cut->isWorthIt() && !progress.isCancelled() ? cut->path : std::vector<int>{};
}

/// Proposes the automatic cuts of each piece according to the options.
CutProposer proposerFor(const LoadOptions& options, const Garment& garment) {
    if (options.cutStyle == CutStyle::Topology) {
        return {.partCrossing = cutOfCrossings};
    }
    const AdviceOptions requested{options.isFrontSwapped, options.enoughStrain};
    const bool isForForms = options.cutStyle == CutStyle::Tailor || requested.enoughStrain;
    const auto propose = [requested, isForForms, files = garment.files](
                             const std::shared_ptr<const Piece>& piece,
                             const std::vector<UserCut>& own, const Progress& progress) {
        AdviceOptions inFile = requested;
        inFile.borders = fileBorders(*piece, *files[static_cast<std::size_t>(piece->file)]->soup);
        CutAdvice advice = adviseCuts(piece, own, inFile, progress);
        ProposedCuts made;
        for (AdvisedCut& cut : advice.cuts) {
            if (cut.isNeeded && (advice.isWorn || isForForms)) {
                made.cuts.push_back({std::move(cut.what.cut), std::move(cut.evidence)});
            }
        }
        made.nameOf = std::move(advice.nameOf);
        return made;
    };
    // The number encodes all options, the strain in steps of one millionth.
    const double enough = requested.enoughStrain ? 1e6 * *requested.enoughStrain : -1;
    const int way = 8 + 4 * static_cast<int>(enough) + (isForForms ? 2 : 0) +
                    (requested.isFrontSwapped ? 1 : 0);
    return {propose, cutOfCrossings, way, requested.enoughStrain.has_value()};
}

/// Notes holes: they are no fault, but most methods change the length of their rims.
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
    const auto isNamed = [](const SeamSettings& stated) { return !stated.name.empty(); };
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
    CutPieces cut = cutPieces(joined.pieces, cutsInPieceSpace(seams, garment), options.autoCut,
                              Progress(progress, kCuttingShare), garment.cutRecords,
                              proposerFor(options, garment));
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
