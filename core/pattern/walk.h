// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/pattern/notches.h"
#include "core/pattern/segments.h"

namespace toile {

/// A place at which the two sides of a seam are laid on each other: its start, a notch or its end;
/// and the way there from the station before. Lengths in the pattern, mm.
struct WalkStation {
    SeamMatch at{};                ///< arc lengths in 3D on either outline
    int notch = -1;                ///< of those of the seam; -1: an end without one
    double left = 0, right = 0;    ///< from the station before; 0 at the start
    double ease = 0;               ///< by how much the left one is meant to be longer
    std::optional<double> kink{};  ///< at an end, as drawn, where it has one (`findSeamEnds`)

    /// What nobody wants.
    double error() const { return left - right - ease; }
};

struct SeamWalk {
    int seam = -1;                        ///< index into the graph
    std::vector<WalkStation> stations{};  ///< from its start to its end, two at least

    double largestError() const;  ///< of its stations, as an amount
};

/// Errors up to this are rounding, mm.
inline constexpr double kWalkTolerance = 1e-6;

/// Walks along every sewn seam whose sides are both flat, as a pattern maker does, from notch to
/// notch. A seam's ease (`easeOf`) lies where the outlines are to have it (`PieceResult::targets`;
/// else as in 3D), and what they do not have is spread evenly along the seam; so the errors of its
/// stations add up to SeamMeasure::errorMm.
/// @param segments  of the exact outlines  @param notches  per seam (`findNotches`)
/// @return by seam  Cost: linear in the outlines, and stations. Pure.
std::vector<SeamWalk> walkSeams(const Garment& garment, const PieceResults& results,
                                const std::vector<OutlineSegments>& segments,
                                const std::vector<std::vector<Notch>>& notches);

}  // namespace toile
