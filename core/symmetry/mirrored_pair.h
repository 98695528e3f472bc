// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Outlines here are closed lines in the plane, #n x 2, mm, anti-clockwise, without edges of no
/// length. A place is an arc length from the first corner on. Mirror images are in the y axis.

/// Two places that mirror each other, one on either outline.
struct MirrorEnd {
    double a = 0, b = 0;
};

/// Two outlines that are mirror images of each other: row k of one is row #m - k of the other,
/// modulo #m, with the opposite x, bit by bit.
struct MirroredPair {
    Points2 a, b;  ///< #m x 2; the first corners mirror each other
    /// Per corner of the outlines that were given: its row. Other rows are corners of the other
    /// outline, and ends of segments.
    std::vector<int> rowOfA, rowOfB;
};

/// An outline that is its own mirror image: row k and row #m - k, modulo #m, bit by bit.
struct SymmetricLine {
    Points2 line;          ///< #m x 2
    std::vector<int> row;  ///< per corner of the outline that was given
};

/// The mirror image, from the place `start` on and in its own anti-clockwise sense. A place within
/// an edge becomes a corner.  Cost: linear. Pure.
Points2 mirroredLine(const Points2& line, double start);

/// The outline between one and another's mirror image: the angles at which both turn, at equal
/// shares of each segment, are averaged, and the outline that comes nearest to the means of all
/// closes with exact lengths (boundary problem, [Wang05] eq. 9). So each segment is as long as
/// before, and so is each edge, measured along the line: where the other outline has a corner
/// within an edge, the edge may bend.
/// @param ends  ends of segments, one at least: in order along `a`, backwards along `b`. The
///              segments are equally long on both (`commonLengths`); else their means are taken
/// Errors: those of solveBoundary.  Cost: n log n, and the boundary problem. Re-entrant.
Result<MirroredPair> meanLine(const Points2& a, const Points2& b,
                              const std::vector<MirrorEnd>& ends);

/// The same for an outline and itself.
/// @param from, to  the places where the mirror line crosses the outline, which halve its length:
///                  the first comes to lie at the origin, the other one above
/// Errors and cost as for `meanLine`.
Result<SymmetricLine> symmetricLine(const Points2& line, double from, double to);

}  // namespace toile
