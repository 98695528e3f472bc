// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/pipeline.h"

#include <algorithm>
#include <utility>

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/export/drawing.h"
#include "core/export/writers.h"
#include "core/pattern/target_lengths.h"
#include "core/pipeline/draw_lines.h"
#include "core/pipeline/piece_work.h"
#include "core/symmetry/symmetry.h"

namespace toile {
namespace {

std::string lowerCaseEnding(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), lowered);
    return ending;
}

/// Of the time that an export takes, about; the rest is writing.
constexpr double kMakingShare = 0.8;

/// Whether a pattern has lines that a UV map does not show.
bool isMoreThanOutlines(const Pattern& pattern) {
    return pattern.hasAllowance || pattern.hasNotches ||
           std::ranges::any_of(pattern.pieces, [](const PatternPiece& piece) {
               return !piece.internals.empty() || !piece.extensions.empty();
           });
}

/// @param ending  one that `canExport`
std::string bytesOf(const std::string& ending, const Garment& garment, const PieceResults& results,
                    const LaidOutPattern& laid, const DrawingWords& words) {
    if (ending == ".json") {
        return writeReport(garment, results, laid.pattern);
    }
    if (ending == ".obj") {
        std::string obj = writeObj(garment, results, laid.whole);
        if (isMoreThanOutlines(laid.wholePattern)) {
            obj += writeObjLines(draw(laid.wholePattern, laid.whole, words),
                                 millimetresPer(garment.files.front()->unit));
        }
        return obj;
    }
    const Drawing drawing = draw(laid.pattern, laid.marker, words);
    return ending == ".svg" ? writeSvg(drawing) : writeDxf(drawing);
}

}  // namespace

std::shared_ptr<const Symmetry> symmetryOf(const Garment& garment, const LineSettings& lines,
                                           const Progress& progress) {
    if (lines.mirror == Mirror::None) {
        return nullptr;
    }
    auto found = findSymmetry(garment, progress);
    return found ? std::make_shared<const Symmetry>(std::move(*found)) : nullptr;
}

LaidOutPattern inRows(const Garment& garment, const PieceResults& results,
                      const LineSettings& lines, bool byHalf) {
    Pattern pattern = makePattern(garment, results, lines, symmetryOf(garment, lines));
    for (PatternPiece& piece : pattern.pieces) {
        piece.byHalf = byHalf;
    }
    return laidOut(std::move(pattern));
}

bool canExport(const std::filesystem::path& path) {
    const std::string ending = lowerCaseEnding(path);
    return ending == ".svg" || ending == ".dxf" || ending == ".obj" || ending == ".json";
}

Result<void> exportFile(const std::filesystem::path& path, const Garment& garment,
                        const PieceResults& results, const LaidOutPattern& laid,
                        const Progress& progress, const DrawingWords& words) {
    if (!canExport(path)) {
        return Error{ErrorCode::UnknownFormat, Subject::file(path.string()),
                     "ending \"" + lowerCaseEnding(path) + "\""};
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    const std::string bytes = bytesOf(lowerCaseEnding(path), garment, results, laid, words);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    progress.report(kMakingShare);
    return writeFile(path, bytes);
}

PieceResults flattenGarment(const Garment& garment, const FlattenOptions& options,
                            Progress& progress, int threads, const LineSettings& lines) {
    progress.start(1);
    Progress solving(progress, solvingShare(lines)), drawing(progress, 1 - solvingShare(lines));
    const auto found = symmetryOf(garment, lines, progress);
    const Symmetry* const symmetry = found.get();
    const std::vector<OutlineTargets> targets = outlineTargets(garment, lines, symmetry);
    std::vector<PieceTask> tasks;
    for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
        tasks.push_back({garment.pieces[p], {}, targets[p]});
    }
    PieceResults results;
    for (DoneTask& done : workOn(std::move(tasks), options, solving, threads)) {
        results.push_back(std::move(done.result));
    }
    results = drawLines(garment, std::move(results), lines, symmetry, {}, drawing, threads);
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

}  // namespace toile
