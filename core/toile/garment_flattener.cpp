// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/toile/garment_flattener.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/flatten/isometric/flat_energy.h"
#include "core/garment/garment.h"
#include "core/garment/lineage.h"
#include "core/pattern/target_lengths.h"
#include "core/toile/draw_lines.h"
#include "core/toile/piece_work.h"

namespace toile {
namespace {

/// False for errors that may not recur for the same piece, and for pieces that were left out.
bool isLasting(const PieceResult& result) {
    return !result.error || (result.error->code != ErrorCode::Cancelled &&
                             result.error->code != ErrorCode::OutOfMemory && !isLeftOut(result));
}

/// True if a result is of these options and lengths, and of this cloth if that matters.
bool isOf(const PieceResult& result, const FlattenOptions& options, const OutlineTargets& targets,
          const PieceClothPointer& cloth) {
    return result.options == options && result.targets == targets &&
           (!options.energy->readsCloth || isSameCloth(result.cloth, cloth));
}

/// The positions of the seams as numbers, for comparison.
std::vector<double> placesOf(const SeamGraph& graph) {
    std::vector<double> places;
    for (const Seam& seam : graph.seams) {
        for (const SeamSide* side : {&seam.left, &seam.right}) {
            for (const int number : {side->piece, side->loop}) {
                places.push_back(number);
            }
            places.push_back(side->start);
            places.push_back(side->end);
        }
        places.push_back(seam.stacked ? 1 : 0);
    }
    return places;
}

}  // namespace

std::shared_ptr<const Symmetry> GarmentFlattener::symmetryOf(const Garment& garment,
                                                             const LineSettings& lines,
                                                             const Progress& progress) {
    if (lines.mirror == Mirror::None) {
        return nullptr;
    }
    std::shared_ptr<const KeptSymmetry> kept;
    {
        const std::lock_guard lock(mutex_);
        kept = symmetry_;
    }
    const bool hasPlane = kept && kept->uncut == garment.uncut;
    std::vector<double> places = placesOf(garment.seams);
    if (!hasPlane || kept->pieces != garment.pieces || kept->places != places) {
        const auto plane = hasPlane ? kept->plane : findMirrorPlane(garment.uncut, progress);
        auto found = plane ? std::optional(symmetryIn(*plane, garment, progress)) : std::nullopt;
        if (progress.isCancelled()) {
            return nullptr;
        }
        auto close = found ? std::optional(withinTolerance(garment, *found)) : std::nullopt;
        kept = std::make_shared<const KeptSymmetry>(
            KeptSymmetry{garment.uncut, plane, garment.pieces, std::move(places), std::move(found),
                         std::move(close)});
        const std::lock_guard lock(mutex_);
        symmetry_ = kept;
    }
    const auto& wanted = lines.mirror == Mirror::Close ? kept->close : kept->found;
    return wanted ? std::shared_ptr<const Symmetry>(kept, &*wanted) : nullptr;
}

std::vector<GarmentFlattener::KeptPointer> GarmentFlattener::snapshot() const {
    const std::lock_guard lock(mutex_);
    return kept_;
}

void GarmentFlattener::reset() {
    const std::lock_guard lock(mutex_);
    kept_.clear();
    symmetry_.reset();
}

std::size_t GarmentFlattener::keptBytes() const {
    std::size_t bytes = 0;
    for (const auto& kept : snapshot()) {
        bytes += kept->flattener.keptBytes();
    }
    return bytes;
}

PieceResults GarmentFlattener::flatten(const Garment& garment, const FlattenOptions& options,
                                       Progress& progress, int threads, const PieceResults& known,
                                       const LineSettings& lines, const OnPiece& onPiece,
                                       const PieceCloths& cloths) {
    progress.start(1);
    Progress solving(progress, solvingShare(lines)), drawing(progress, 1 - solvingShare(lines));
    const auto symmetry = symmetryOf(garment, lines, progress);
    PieceResults results =
        flattenExactly(garment, options, solving, threads, known,
                       outlineTargets(garment, lines, symmetry.get()), cloths, onPiece);
    results = drawLines(garment, std::move(results), lines, symmetry.get(), known, drawing, threads,
                        &ending_);
    if (!progress.isCancelled()) {
        progress.report(1);
    }
    return results;
}

PieceResults GarmentFlattener::flattenExactly(const Garment& garment, const FlattenOptions& options,
                                              Progress& progress, int threads,
                                              const PieceResults& known,
                                              const std::vector<OutlineTargets>& targets,
                                              const PieceCloths& cloths, const OnPiece& onPiece) {
    const auto clothOf = [&cloths](std::size_t p) {
        return p < cloths.size() ? cloths[p] : nullptr;
    };
    const std::vector<KeptPointer> before = snapshot();
    std::map<const Piece*, KeptPointer> byPiece;
    Pieces piecesBefore;
    for (const KeptPointer& kept : before) {
        byPiece.emplace(kept->result->piece.get(), kept);
        piecesBefore.push_back(kept->result->piece);
    }
    for (const auto& shown : known) {
        const auto& result = shown && shown->exact ? shown->exact : shown;
        if (!result || !(result->options == options) || !isLasting(*result)) {
            continue;
        }
        const auto kept = byPiece.find(result->piece.get());
        if (kept == byPiece.end() ||
            !isOf(*kept->second->result, options, result->targets, result->cloth)) {
            byPiece[result->piece.get()] = std::make_shared<const Kept>(Kept{result, {}});
        }
    }
    const std::vector<int> ancestors = predecessors(piecesBefore, garment.pieces);

    PieceResults results(garment.pieces.size());
    std::vector<KeptPointer> kept(garment.pieces.size());
    std::vector<PieceTask> tasks;
    std::vector<std::size_t> place;  // piece index of each task
    std::vector<char> isWithin(garment.pieces.size(), 0);
    std::size_t bytes = 0;
    for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
        const std::shared_ptr<const Piece>& piece = garment.pieces[p];
        if (const std::size_t more = PieceFlattener::expectedBytes(*piece);
            more <= mostBytes_ - bytes) {
            isWithin[p] = 1;
            bytes += more;
        }
        const auto same = byPiece.find(piece.get());
        kept[p] = same != byPiece.end() ? same->second : nullptr;
        if (kept[p] && isOf(*kept[p]->result, options, targets[p], clothOf(p))) {
            results[p] = kept[p]->result;
            continue;
        }
        if (!kept[p] && ancestors[p] >= 0) {
            kept[p] = before[static_cast<std::size_t>(ancestors[p])];
        }
        PieceTask task{piece, {}, targets[p], clothOf(p)};
        if (isWithin[p] != 0) {
            task.flattener = kept[p] ? kept[p]->flattener : PieceFlattener();
        }
        tasks.push_back(std::move(task));
        place.push_back(p);
    }

    std::vector<DoneTask> done =
        workOn(std::move(tasks), options, progress, threads, &ending_, onPiece);
    for (std::size_t t = 0; t < done.size(); ++t) {
        const std::size_t p = place[t];
        results[p] = done[t].result;
        if (isLasting(*done[t].result)) {
            kept[p] = std::make_shared<const Kept>(
                Kept{done[t].result, done[t].flattener.value_or(PieceFlattener())});
        }
    }
    for (std::size_t p = 0; p < kept.size(); ++p) {
        if (kept[p] && isWithin[p] == 0) {
            kept[p] = std::make_shared<const Kept>(Kept{kept[p]->result, {}});
        }
    }
    std::erase(kept, nullptr);
    const std::lock_guard lock(mutex_);
    kept_ = std::move(kept);
    return results;
}

PieceResults GarmentFlattener::settle(const Garment& garment, PieceResults results,
                                      Progress& progress, int threads, const LineSettings& lines) {
    const PieceResults known = results;
    progress.start(1);
    Progress solving(progress, solvingShare(lines)), drawing(progress, 1 - solvingShare(lines));
    results = settleExactly(exactResults(std::move(results)), solving, threads);
    const auto symmetry = symmetryOf(garment, lines, progress);
    results = drawLines(garment, std::move(results), lines, symmetry.get(), known, drawing, threads,
                        &ending_);
    if (!progress.isCancelled()) {
        progress.report(1);
    }
    return progress.isCancelled() && draws(lines) ? known : results;
}

PieceResults GarmentFlattener::settleExactly(PieceResults results, Progress& progress,
                                             int threads) {
    const auto warm = [](const auto& result) { return result && isWarm(*result); };
    std::vector<KeptPointer> kept = snapshot();
    for (auto first = std::ranges::find_if(results, warm);
         first != results.end() && !progress.isCancelled();
         first = std::ranges::find_if(results, warm)) {
        const FlattenOptions options = (*first)->options;
        std::vector<PieceTask> tasks;
        std::vector<std::size_t> place;  // piece index of each task
        for (std::size_t p = 0; p < results.size(); ++p) {
            if (warm(results[p]) && results[p]->options == options) {
                tasks.push_back(
                    {results[p]->piece, PieceFlattener(), results[p]->targets, results[p]->cloth});
                place.push_back(p);
            }
        }
        std::vector<DoneTask> done = workOn(std::move(tasks), options, progress, threads, &ending_);
        for (std::size_t t = 0; t < done.size(); ++t) {
            if (!isLasting(*done[t].result)) {
                continue;
            }
            auto& result = results[place[t]];
            const auto known = std::ranges::find_if(
                kept, [&](const KeptPointer& one) { return one->result->piece == result->piece; });
            result = done[t].result;
            if (known != kept.end()) {
                const bool keeps = (*known)->flattener.keptBytes() > 0;
                *known = std::make_shared<const Kept>(
                    Kept{result, keeps ? *done[t].flattener : PieceFlattener()});
            }
        }
        if (std::ranges::any_of(done,
                                [](const DoneTask& one) { return !isLasting(*one.result); })) {
            break;
        }
    }
    const std::lock_guard lock(mutex_);
    kept_ = std::move(kept);
    return results;
}

namespace {

/// Whether all members of a piece are unchanged.
bool isAsBefore(const Piece& now, const Piece& before) {
    const auto same = [](const auto& a, const auto& b) -> bool {
        return a.rows() == b.rows() && a == b;
    };
    return now.name == before.name && now.file == before.file &&
           now.sourceVertex == before.sourceVertex && now.sourceFace == before.sourceFace &&
           same(now.mesh.F, before.mesh.F) && same(now.mesh.V, before.mesh.V) &&
           now.reference.has_value() == before.reference.has_value() &&
           (!now.reference || same(*now.reference, *before.reference));
}

}  // namespace

void reusePieces(Pieces& pieces, const Garment& before) {
    std::map<PieceId, Pieces> known;
    const auto know = [&known](const std::shared_ptr<const Piece>& piece) {
        known[piece->id].push_back(piece);
    };
    std::ranges::for_each(before.uncut, know);
    std::ranges::for_each(before.pieces, know);
    for (const CutRecord& cut : before.cutRecords) {
        know(cut.whole);
    }
    for (auto& piece : pieces) {
        for (const auto& old : known[piece->id]) {
            if (piece == old || isAsBefore(*piece, *old)) {
                piece = old;
                break;
            }
        }
    }
}

}  // namespace toile
