// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/pattern/allowance.h"
#include "core/pattern/line_settings.h"
#include "core/pattern/pattern.h"

namespace toile {

/// The width of the allowance beside a segment where nobody has said otherwise, mm: that of seams,
/// that of hems along free edges, none at folds of the cloth and between the legs of a dart.
double usualAllowance(const PatternSegment& segment, const AllowanceWidths& widths);

/// How allowances meet where segment k begins, stated or usual: where a hem ends beside another
/// edge its allowance is cut so that, folded up, it lies on the piece edge to edge.
CornerRule cornerOf(const PatternPiece& piece, std::size_t k);

/// What allowances are laid round.
struct AllowanceBase {
    Points2 line;
    std::vector<AllowanceStretch> stretches;
};

/// The outline by its segments, with darts closed by their caps (`cappedOutline`), each with the
/// allowance that runs on over it.  Cost: that of `findDarts`. Pure.
AllowanceBase allowanceBase(const PatternPiece& piece);

/// The line round the outline, the caps of its darts and the allowances of its segments
/// (`cuttingLine`); the outline where it has neither.  Cost: that of `cuttingLine`. Pure.
Points2 cuttingLineOf(const PatternPiece& piece);

/// The width of the allowance at a place of the outline, which is so long.
/// Cost: linear in the segments. Pure.
double allowanceAt(const PatternPiece& piece, double length, double at);

}  // namespace toile
