// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/toile/pipeline.h"

#include <algorithm>
#include <utility>

#include "core/assemble/cut_pieces.h"
#include "core/flatten/flatten.h"
#include "core/mesh/cotangents.h"
#include "core/pattern/target_lengths.h"
#include "core/quality/piece_quality.h"
#include "core/symmetry/symmetry.h"
#include "core/toile/draw_lines.h"
#include "core/toile/piece_work.h"

namespace toile {

std::shared_ptr<const Symmetry> symmetryOf(const Garment& garment, const LineSettings& lines,
                                           const Progress& progress) {
    if (lines.mirror == Mirror::None) {
        return nullptr;
    }
    auto found = findSymmetry(garment, progress);
    if (found && lines.mirror == Mirror::Close) {
        found = withinTolerance(garment, std::move(*found));
    }
    return found ? std::make_shared<const Symmetry>(std::move(*found)) : nullptr;
}

PieceResults flattenGarment(const Garment& garment, const FlattenOptions& options,
                            Progress& progress, int threads, const LineSettings& lines,
                            const PieceCloths& cloths, EndingWorkers* ending) {
    progress.start(1);
    Progress solving(progress, solvingShare(lines)), drawing(progress, 1 - solvingShare(lines));
    const auto found = symmetryOf(garment, lines, progress);
    const Symmetry* const symmetry = found.get();
    const std::vector<OutlineTargets> targets = outlineTargets(garment, lines, symmetry);
    std::vector<PieceTask> tasks;
    for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
        tasks.push_back(
            {garment.pieces[p], {}, targets[p], p < cloths.size() ? cloths[p] : nullptr});
    }
    PieceResults results;
    for (DoneTask& done : workOn(std::move(tasks), options, solving, threads, ending)) {
        results.push_back(std::move(done.result));
    }
    results = drawLines(garment, std::move(results), lines, symmetry, {}, drawing, threads, ending);
    if (!progress.isCancelled()) {
        progress.report(1);
    }
    return results;
}

Comparison compareMethods(const Garment& garment, std::span<const Method> methods,
                          const FlattenOptions& options, Progress& progress) {
    Comparison comparison;
    const auto count = static_cast<double>(methods.size());
    for (std::size_t k = 0; k < methods.size(); ++k) {
        progress.setShare(static_cast<double>(k) / count, static_cast<double>(k + 1) / count);
        FlattenOptions one = options;
        one.method = methods[k];
        comparison.methods.push_back(
            compared(methods[k], garment, flattenGarment(garment, one, progress)));
    }
    return comparison;
}

Result<StrainFigures> solvedStrain(const std::shared_ptr<const Piece>& piece,
                                   const std::vector<UserCut>& own, const CutAdvice& advice,
                                   std::size_t count, const FlattenOptions& options,
                                   Progress& progress) {
    std::vector<UserCut> cuts = own;
    for (std::size_t k = 0; k < std::min(count, advice.cuts.size()); ++k) {
        cuts.push_back(advice.cuts[k].what.cut);
        cuts.back().id = {};
    }
    const CutPieces made = cutPieces({piece}, cuts, true, Progress(progress, 0.3));
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    std::vector<std::pair<double, double>> strains;
    for (const auto& part : made.pieces) {
        const auto flat = flatten(
            *part, options, Progress(progress, 0.7 / static_cast<double>(made.pieces.size())));
        if (!flat) {
            return flat.error();
        }
        const Eigen::VectorXd ofEdges = distortionFields(*part, flat->Q).edgeStrain;
        for (int f = 0; f < part->mesh.F.rows(); ++f) {
            const double third = cornerProducts(part->mesh, f).doubledArea / 6;
            for (int k = 0; k < 3; ++k) {
                strains.emplace_back(ofEdges[part->table.faceEdges(f, k)], third);
            }
        }
    }
    return strainFigures(std::move(strains));
}

}  // namespace toile
