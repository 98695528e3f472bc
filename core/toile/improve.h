// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/prove/proof.h"
#include "core/toile/toile.h"

namespace toile {

inline constexpr int kImproveRounds = 4;

/// Options of improving a pattern's fit.
struct ImproveOrder {
    /// Precondition: of the garment's own pattern, so no file and no reference.
    ProofOrder proof{};
    PatternOrder pattern{};       ///< `threads` is ignored
    int rounds = kImproveRounds;  ///< at most; >= 0
    /// Called after each round, on the working thread; may be empty.
    std::function<void(const struct ImproveRound&)> watch{};
};

/// One pattern that was tried.
struct ImproveRound {
    int number = 0;            ///< 0: the original pattern
    double share = 0;          ///< share of the gap by which the virtual design was moved
    bool isSmooth = false;     ///< moved by a smoothed gap, which leaves folds as they are
    sew::SpreadFigures gap{};  ///< mm
    double gain = 0;           ///< part of the best mean before it; below 0 if worse; at most -1 if
                               ///< its cloth, unlike the best's, has not come to rest
    bool isKept = false;       ///< it is the best so far
};

/// Why the rounds ended.
enum class ImproveEnd {
    Rounds,      ///< all requested rounds are done
    LittleGain,  ///< the last gained less than kMinGain
    GapGrows,    ///< the gap grows even with a smoothed move and half the gap
    NotFlat,     ///< the virtual design could not be flattened or sewn: `Improved::why`
};

/// A round that gains less than this part of the mean gap is the last.
inline constexpr double kMinGain = 0.02;

struct Improved {
    /// The best pattern found, one result per piece of the garment. Outlines have the lengths of
    /// `PieceResult::targets`, not those of the design.
    PieceResults results;
    std::shared_ptr<const Proof> proof;  ///< of it; changed lengths are no fault
    std::vector<ImproveRound> rounds;    ///< the first is the original pattern
    ImproveEnd ended = ImproveEnd::Rounds;
    std::optional<Error> why{};

    /// Part of the mean gap that was removed, in [0, 1).
    double gain() const;
};

/// Finds a pattern that comes to rest nearer to the design than one with the design's own lengths,
/// for example if cloth sags under its weight. The pattern is the flattening, with seams of equal
/// length, of a *virtual design* T, which starts as the design D. Each round flattens T, sews the
/// pattern over D, finds the rest position X of each vertex, and moves T against it: T - a (X - D),
/// alike on both sides of seams; a = 1. If the gap grows, X - D is smoothed over 25 mm, but at most
/// ten edges, because moving against a fold makes a dent and another fold. If it grows again, a =
/// 1/2. The best pattern is kept.
/// @param results  of the garment, one per piece; pieces that are not flat are left out
/// Errors: those of `proofOf` for the original pattern; Cancelled.
/// Same input, same bytes. Cost: a flattening and a proof per round.
Result<Improved> improvePattern(const Garment& garment, const PieceResults& results,
                                const ImproveOrder& order, Progress& progress);

}  // namespace toile
