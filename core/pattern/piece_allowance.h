// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/pattern/allowance.h"
#include "core/pattern/capped_outline.h"
#include "core/pattern/line_settings.h"
#include "core/pattern/pattern.h"

namespace toile {

/// Default width of the allowance of a segment, mm: that of seams; that of hems along free edges
/// without facing; 0 at folds of the cloth and between the legs of a dart.
double usualAllowance(const PatternSegment& segment, const AllowanceWidths& widths);

/// How allowances meet where segment k starts, set or default: where a hem ends beside another
/// edge, its allowance is shaped so that, folded up, it matches the piece edge to edge.
CornerRule cornerOf(const PatternPiece& piece, std::size_t k);

/// The base line of the allowances.
struct AllowanceBase {
    Points2 line;
    std::vector<AllowanceStretch> stretches;
};

/// A line with its stretches, each with the allowance of its segment.  Cost: linear. Pure.
AllowanceBase allowanceBase(const PatternPiece& piece, CappedOutline outline);

/// Sets the cutting line of a piece: around its outline, the caps of its darts (`cappedOutline`),
/// its extensions (`extendedOutline`) and the allowances of its segments (`cuttingLine`).  Cost:
/// that of `cuttingLine`. Pure.
void addCuttingLine(PatternPiece& piece);

/// The segment at a place of the outline of this length; -1 if there is none.
/// Cost: linear in the segments. Pure.
int segmentAt(const PatternPiece& piece, double length, double at);

/// The width of the allowance at a place of the outline of this length.
/// Cost: linear in the segments. Pure.
double allowanceAt(const PatternPiece& piece, double length, double at);

}  // namespace toile
