// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/toile/improve.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/pattern/target_lengths.h"
#include "core/quality/piece_quality.h"
#include "core/toile/draw_lines.h"
#include "core/toile/piece_work.h"
#include "core/toile/pipeline.h"
#include "core/toile/sewn_moves.h"

namespace toile {
namespace {

/// Approximate share of a round's time.
constexpr double kShareOfFlattening = 0.2;

/// Smoothing length of moves that leave folds alone, mm.
constexpr double kSmoothing = 25;

/// How far a round moves the design.
struct Stride {
    double share = 1;
    bool isSmooth = false;
};

/// After a round that made the fit worse, the next of these is used.
constexpr Stride kStrides[] = {{1, false}, {1, true}, {0.5, true}};

/// Gain recorded for a round whose cloth has not come to rest.
constexpr double kUnsettled = -1;

/// The result of a piece's virtual form as a result of the piece itself.
std::shared_ptr<const PieceResult> asOf(const std::shared_ptr<const Piece>& piece,
                                        const PieceResult& found) {
    auto result = std::make_shared<PieceResult>(found);
    result->piece = piece;
    result->targets.lengths = outlineLengths(*found.piece, found.targets);
    result->targets.changed.clear();
    const Eigen::VectorXd design = outlineLengths(*piece, {});
    double at = 0;
    for (Eigen::Index k = 0; k < design.size(); at += design[k++]) {
        result->targets.changed.push_back(
            {LengthCause::Improving, at, at + design[k], result->targets.lengths[k] / design[k]});
    }
    if (result->flat) {
        result->quality = measure(*piece, result->flat->Q);
        measureOutline(*piece, *result->flat, result->targets, *result->quality);
    }
    return result;
}

/// Improved patterns differ from the design's lengths on purpose, so drop those faults.
std::shared_ptr<const Proof> withoutLengths(Proof proof) {
    std::erase_if(proof.faults,
                  [](const Finding& fault) { return fault.kind == FindingKind::LengthDiffers; });
    return std::make_shared<const Proof>(std::move(proof));
}

struct Tried {
    PieceResults results;
    std::shared_ptr<const Proof> proof;
};

class Improving {
public:
    Improving(const Garment& garment, const PieceResults& results, const ImproveOrder& order,
              const Progress& progress)
        : garment_(garment),
          start_(results),
          order_(order),
          symmetry_(draws(order.pattern.lines) ? symmetryOf(garment, order.pattern.lines, progress)
                                               : nullptr) {}

    Result<Tried> asItIs(const Progress& progress) const { return proved(start_, progress); }

    /// The pattern of a virtual design. @param positions  of the vertices of its pieces
    Result<Tried> of(const std::vector<Points3>& positions, const Progress& progress) const {
        auto flat =
            flattened(movedGarment(garment_, positions), Progress(progress, kShareOfFlattening));
        if (!flat) {
            return flat.error();
        }
        auto tried = proved(std::move(*flat), Progress(progress, 1 - kShareOfFlattening));
        if (tried) {
            tried->proof = withoutLengths(*tried->proof);
        }
        return tried;
    }

    /// A virtual design moved against the displacement of the sewn cloth.
    std::vector<Points3> movedAgainst(std::vector<Points3> positions, const Proof& proof,
                                      const Stride& stride) const {
        std::vector<Points3> moves;
        for (std::size_t p = 0; p < positions.size(); ++p) {
            const bool isSewn = proof.pieces[p].isSewn();
            moves.push_back(isSewn ? Points3(proof.pieces[p].sewn - garment_.pieces[p]->mesh.V)
                                   : Points3(0, 3));
        }
        SewnMoves sewn(garment_, std::move(moves));
        if (stride.isSmooth) {
            sewn.smooth(kSmoothing);
        }
        for (std::size_t p = 0; p < positions.size(); ++p) {
            if (sewn.moves()[p].rows() > 0) {
                positions[p] -= stride.share * sewn.moves()[p];
            }
        }
        return positions;
    }

    std::vector<Points3> design() const {
        std::vector<Points3> positions;
        for (const auto& piece : garment_.pieces) {
            positions.push_back(piece->mesh.V);
        }
        return positions;
    }

private:
    bool isFlat(std::size_t piece) const { return start_[piece] && start_[piece]->flat; }

    Result<PieceResults> flattened(const Garment& moved, const Progress& progress) const {
        const auto symmetry = symmetryOf(moved, order_.pattern.lines, progress);
        const auto targets = outlineTargets(moved, order_.pattern.lines, symmetry.get());
        std::vector<PieceTask> tasks;
        std::vector<std::size_t> place;  // piece index of each task
        for (std::size_t p = 0; p < moved.pieces.size(); ++p) {
            if (isFlat(p)) {
                tasks.push_back({moved.pieces[p], {}, targets[p], start_[p]->cloth});
                place.push_back(p);
            }
        }
        const double share = solvingShare(order_.pattern.lines);
        Progress solving(progress, share), drawing(progress, 1 - share);
        const int threads = order_.proof.settings.threads;
        const auto done = workOn(std::move(tasks), order_.pattern.flattening, solving, threads);
        PieceResults results = start_;
        for (std::size_t t = 0; t < done.size(); ++t) {
            const PieceResult& found = *done[t].result;
            if (!found.flat) {
                return found.error.value_or(Error{ErrorCode::Cancelled});
            }
            results[place[t]] = asOf(garment_.pieces[place[t]], found);
        }
        return drawLines(garment_, std::move(results), order_.pattern.lines, symmetry_.get(), {},
                         drawing, threads);
    }

    Result<Tried> proved(PieceResults results, const Progress& progress) const {
        const FinishedPattern made = makePattern(garment_, results, order_.pattern);
        auto proof = proofOf(made.source(), order_.proof, progress);
        return proof ? Result<Tried>(Tried{std::move(results), std::move(*proof)}) : proof.error();
    }

    const Garment& garment_;
    const PieceResults& start_;
    const ImproveOrder& order_;
    std::shared_ptr<const Symmetry> symmetry_;
};

}  // namespace

double Improved::gain() const {
    const double before = rounds.empty() ? 0 : rounds.front().gap.mean;
    return before > 0 ? 1 - proof->gap.mean / before : 0;
}

Result<Improved> improvePattern(const Garment& garment, const PieceResults& results,
                                const ImproveOrder& order, Progress& progress) {
    progress.start(1);
    const Improving improving(garment, results, order, Progress(progress, 0));
    const double part = 1.0 / (order.rounds + 1);
    auto first = improving.asItIs(Progress(progress, part));
    if (!first) {
        return first.error();
    }
    Improved improved{std::move(first->results), std::move(first->proof), {}};
    const auto note = [&](ImproveRound round) {
        improved.rounds.push_back(round);
        if (order.watch) {
            order.watch(round);
        }
    };
    note({.gap = improved.proof->gap, .isKept = true});
    std::vector<Points3> best = improving.design();
    const Stride* stride = std::begin(kStrides);
    for (int number = 1; number <= order.rounds; ++number) {
        std::vector<Points3> positions = improving.movedAgainst(best, *improved.proof, *stride);
        auto tried = improving.of(positions, Progress(progress, part));
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        if (!tried) {
            improved.ended = ImproveEnd::NotFlat;
            improved.why = tried.error();
            return improved;
        }
        const double before = improved.proof->gap.mean;
        // Cloth whose steps ran out is still near its start, the design: that is no gain.
        const bool isWorse = improved.proof->hasSettled && !tried->proof->hasSettled;
        const double change = before > 0 ? 1 - tried->proof->gap.mean / before : 0;
        const double gain = isWorse ? std::min(change, kUnsettled) : change;
        note({number, stride->share, stride->isSmooth, tried->proof->gap, gain, gain > 0});
        if (gain > 0) {
            improved.results = std::move(tried->results);
            improved.proof = std::move(tried->proof);
            best = std::move(positions);
        }
        if (gain >= 0 && gain < kMinGain) {
            improved.ended = ImproveEnd::LittleGain;
            return improved;
        }
        if (gain < 0 && ++stride == std::end(kStrides)) {
            improved.ended = ImproveEnd::GapGrows;
            return improved;
        }
    }
    return improved;
}

}  // namespace toile
