// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/pattern/notches.h"
#include "core/pattern/seam_places.h"
#include "core/pattern/segments.h"

namespace toile {

/// Walked lengths of a seam in the pattern, mm.
struct WalkedLengths {
    double left = 0, right = 0;
    double ease = 0;  ///< by how much the left one is meant to be longer

    /// The unintended difference.
    double error() const { return left - right - ease; }
};

/// From the start of a seam to a place on it. Its ease (`easeOf`) lies where the outlines' targets
/// put it (`PieceResult::targets`; else as in 3D); the rest of the ease is spread evenly along the
/// seam.
/// @param left, right  the loops of its two sides, as drawn  Precondition: the seam has matches.
/// Cost: logarithmic. Pure.
WalkedLengths walkedTo(const Seam& seam, const DrawnLoop& left, const DrawnLoop& right,
                       const SeamMatch& place);

/// A place at which the two sides of a seam are aligned: its start, a notch or its end; and the
/// lengths from the station before, 0 at the start.
struct WalkStation : WalkedLengths {
    SeamMatch at{};                ///< arc lengths in 3D on both outlines
    int notch = -1;                ///< index into the seam's notches; -1: an end without one
    std::optional<double> kink{};  ///< at an end, as drawn, if it has one (`findSeamEnds`)
};

struct SeamWalk {
    int seam = -1;                        ///< index into the graph
    std::vector<WalkStation> stations{};  ///< from its start to its end, at least two

    double largestError() const;  ///< absolute value
};

/// Errors up to this are rounding, mm.
inline constexpr double kWalkTolerance = 1e-6;

/// Walks along every sewn seam whose sides are both flat, as a pattern maker does, from notch to
/// notch (`walkedTo`); the errors of a seam's stations add up to SeamMeasure::errorMm.
/// @param segments  of the exact outlines  @param notches  per seam (`findNotches`)
/// @return by seam  Cost: linear in the outlines, and stations. Pure.
std::vector<SeamWalk> walkSeams(const Garment& garment, const PieceResults& results,
                                const std::vector<OutlineSegments>& segments,
                                const std::vector<std::vector<Notch>>& notches);

struct WalkedGarment {
    std::vector<std::vector<Notch>> notches;  ///< per seam
    std::vector<SeamWalk> walks;              ///< by seam
};

/// The same with the notches of these settings, or the usual ones if they have none.
/// @param lines  with which the results were drawn  @param symmetry  likewise; null: none
/// Cost: that of `findSegments`, `findNotches` and `walkSeams`. Pure.
WalkedGarment walkGarment(const Garment& garment, const PieceResults& results,
                          const LineSettings& lines, const Symmetry* symmetry);

}  // namespace toile
