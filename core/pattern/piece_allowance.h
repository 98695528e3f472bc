// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/pattern/allowance.h"
#include "core/pattern/capped_outline.h"
#include "core/pattern/line_settings.h"
#include "core/pattern/pattern.h"

namespace toile {

/// The width of the allowance beside a segment where nobody has said otherwise, mm: that of seams,
/// that of hems along free edges but faced ones, none at folds of the cloth and between the legs of
/// a dart.
double usualAllowance(const PatternSegment& segment, const AllowanceWidths& widths);

/// How allowances meet where segment k begins, stated or usual: where a hem ends beside another
/// edge its allowance is cut so that, folded up, it lies on the piece edge to edge.
CornerRule cornerOf(const PatternPiece& piece, std::size_t k);

/// What allowances are laid round.
struct AllowanceBase {
    Points2 line;
    std::vector<AllowanceStretch> stretches;
};

/// A line by its stretches, each with the allowance of its segment.  Cost: linear. Pure.
AllowanceBase allowanceBase(const PatternPiece& piece, CappedOutline outline);

/// Gives a piece the line round its outline, the caps of its darts (`cappedOutline`), its
/// extensions
/// (`extendedOutline`) and the allowances of its segments (`cuttingLine`); that of the outline
/// where it has none of these.  Cost: that of `cuttingLine`. Pure.
void addCuttingLine(PatternPiece& piece);

/// The segment at a place of the outline, which is so long; -1 where there is none.
/// Cost: linear in the segments. Pure.
int segmentAt(const PatternPiece& piece, double length, double at);

/// The width of the allowance at a place of the outline, which is so long.
/// Cost: linear in the segments. Pure.
double allowanceAt(const PatternPiece& piece, double length, double at);

}  // namespace toile
