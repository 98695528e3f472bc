// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/mesh_arrays.h"
#include "core/pattern/corner_allowance.h"
#include "core/pattern/darts.h"
#include "core/pattern/line_settings.h"
#include "core/pattern/pattern.h"

namespace toile {

/// A stretch of a closed seam line, from its point `first` to the start of the next stretch; the
/// last one passes the line's first point and ends where the first stretch starts.
struct AllowanceStretch {
    int first = 0;
    double width = 0;                       ///< of the allowance, mm, >= 0
    CornerRule corner = CornerRule::Mitre;  ///< of the corner where it starts
};

/// mm: a point nearer than this to the one before is merged with it.
inline constexpr double kShortestSeamEdge = 1e-5;

/// The cutting line of a piece: around the piece and a strip along every edge of its seam line, as
/// wide as its stretch says. Within a stretch the strips are mitred, as exact as the seam line on
/// curves, and blunted at turns above 67 degrees; between stretches they join by the corner rule.
/// It is the outer line of the covered area: slots or notches closed by the allowances are closed.
/// It lies on the seam line if the width is 0.
/// @param seamLine   #n x 2, n >= 3, mm, anti-clockwise, not crossing itself. Points nearer than
///                   1e-5 mm to the one before are merged with it.
/// @param stretches  at least one, sorted by `first`, which are different indices of points
/// @return anti-clockwise, not crossing itself, to within 1e-5 mm; it may run inside the seam
///         line by as much. About as many points as the seam line.
/// Cost: n log n, plus overlaps of strips; about 5 ms at 3000 points. Pure.
Points2 cuttingLine(const Points2& seamLine, const std::vector<AllowanceStretch>& stretches);

/// From point `first` of a capped outline to the start of the next stretch: a segment of the piece
/// or a part of it, with the caps laid over it.
struct CappedStretch {
    int first = 0;
    int segment = -1;  ///< index into `PatternPiece::segments`; -1: none
};

/// The outline with dart caps in place of dart legs: the base line of the seam allowances, because
/// the cloth between the legs stays.
///
/// `first` is that of an `AllowanceStretch`: to add allowances, give each stretch the width of its
/// segment and the rule of the corner where that starts, and pass them to `cuttingLine`. Segments
/// on legs under a cap do not occur; those of a dart without cap do, as edges of the piece. A cap
/// belongs to the segment beyond the leg over which its dart is laid, because it lies on that
/// segment when sewn. So the allowance beside the cap, folded with it, ends where the segment's own
/// does, even if the widths before and after the dart differ. A segment that is divided by a dart
/// occurs twice.
struct CappedOutline {
    Points2 line;  ///< closed, anti-clockwise, first point not repeated; may start at another point
    std::vector<CappedStretch> stretches;  ///< sorted by `first`; the last passes the first point
};

/// @param darts  of `findDarts`, of this piece; darts without cap stay unchanged
/// Cost: linear in the outline, plus darts times segments. Pure.
CappedOutline cappedOutline(const PatternPiece& piece, const std::vector<PieceDart>& darts);

/// Default width of the allowance of a segment, mm: that of seams; that of its kind along a free
/// edge without facing; 0 at folds of the cloth and between the legs of a dart.
double usualAllowance(const PatternSegment& segment, const AllowanceWidths& widths);

/// Smallest area of a piece with allowances, mm^2: buttons and other trim have none.
inline constexpr double kMinAllowanceArea = 200;

/// Narrows allowances that the user has not set, and records why:
/// - Pieces below `kMinAllowanceArea` have none.
/// - Beside a free edge, an allowance is at most half as wide as the piece is there.
/// - If an edge turns by t over a length l, an allowance w changes its length by w t. That may be
///   3 % of l at necklines, armholes and collars, 10 % at edges that are turned up; but an
///   allowance of 5 mm or 10 mm is left, because less cannot be sewn. All edges of an opening that
///   are turned up have one width, and so have all necklines, all armholes and all collars.
/// Widths are whole steps of 0.5 mm. Cost: edges times points of their outlines. Pure.
void limitAllowances(std::vector<PatternPiece>& pieces);

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

/// Sets the darts of a piece and its cutting line: around its outline, the caps of the darts
/// (`cappedOutline`), its extensions (`extendedOutline`) and the allowances of its segments
/// (`cuttingLine`).  Cost: that of `cuttingLine`. Pure.
void addCuttingLine(PatternPiece& piece);

/// Sets how a piece is cut. The side to which a dart is laid follows the grain, and the cutting
/// line follows the dart: both are found again if the grain changes.
void setCutting(PatternPiece& piece, const Cutting& cutting);

/// The segment at a place of the outline of this length; -1 if there is none.
/// Cost: linear in the segments. Pure.
int segmentAt(const PatternPiece& piece, double length, double at);

/// The width of the allowance at a place of the outline of this length.
/// Cost: linear in the segments. Pure.
double allowanceAt(const PatternPiece& piece, double length, double at);

}  // namespace toile
