// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/prove/proof.h"

namespace toile {

inline constexpr int kImproveRounds = 4;

/// How a pattern is made to fit its design better.
struct ImproveOrder {
    /// Precondition: of the garment's own pattern, so no file and no reference.
    ProofOrder proof{};
    FlattenOptions flattening{};
    LineSettings lines{};
    Fabric fabric = fabricPresets().front();  ///< as `ExportSource::fabric`
    /// The pattern of results, laid out; none: in rows.
    std::function<LaidOutPattern(const PieceResults&)> layOut{};
    int rounds = kImproveRounds;  ///< at most; >= 0
    /// Called after each round, on the working thread; may be empty.
    std::function<void(const struct ImproveRound&)> watch{};
};

/// A pattern that was tried.
struct ImproveRound {
    int number = 0;            ///< 0: the pattern as it was
    double share = 0;          ///< of the gap by which the virtual design was moved
    bool isSmooth = false;     ///< it was moved in the large alone, and folds left as they are
    sew::SpreadFigures gap{};  ///< mm
    double gain = 0;           ///< part of the best mean before it; below 0: it was worse; -1
                               ///< at most where its cloth, unlike the best's, has not come to rest
    bool isKept = false;       ///< it is the best so far
};

/// Why there are no more rounds.
enum class ImproveEnd {
    Rounds,      ///< those asked for are done
    LittleGain,  ///< the last gained less than kLeastGain
    GapGrows,    ///< moved in the large, and by half of the gap, it is worse still
    NotFlat,     ///< the virtual design could not be flattened or sewn: `Improved::why`
};

/// Below this part of the mean gap a round is the last.
inline constexpr double kLeastGain = 0.02;

struct Improved {
    /// The best pattern found, of the garment's own pieces, one result each: outlines have the
    /// lengths that `PieceResult::targets` say, not those of the design.
    PieceResults results;
    std::shared_ptr<const Proof>
        proof;                         ///< of it; lengths that differ from the design are no fault
    std::vector<ImproveRound> rounds;  ///< the first is the pattern as it was
    ImproveEnd ended = ImproveEnd::Rounds;
    std::optional<Error> why{};

    /// Part of the mean gap that is gone, in [0, 1).
    double gain() const;
};

/// Makes a pattern that comes to rest nearer to the design than the one that has the design's own
/// lengths, as where cloth hangs by its weight. It is the flattening, seams of equal length and
/// all, of a *virtual design* T, at first the design D itself. A round flattens T, sews the pattern
/// over D, finds X where each vertex comes to rest, and moves T against it: T - a (X - D), alike on
/// both sides of seams; a = 1. Once that made the gap grow, X - D is smoothed over 25 mm, though no
/// more than ten edges, since a fold that is moved against becomes a dent and another fold; once
/// that did, too, a = 1/2. The best is kept.
/// @param results  of the garment, one per piece; what is not flat in them stays out
/// Errors: those of `proofOf` for the pattern as it is; Cancelled.
/// Same input, same bytes. Cost: a flattening and a proof per round.
Result<Improved> improvePattern(const Garment& garment, const PieceResults& results,
                                const ImproveOrder& order, Progress& progress);

}  // namespace toile
