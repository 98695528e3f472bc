// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Outlines here are closed lines in the plane, #n x 2, mm, anti-clockwise, without zero-length
/// edges. A place is an arc length from the first corner. Mirror images are about the y axis.

/// Two places that mirror each other, one on each outline.
struct MirrorEnd {
    double a = 0, b = 0;
};

/// Two outlines that are mirror images of each other: row k of one is row #m - k of the other,
/// modulo #m, with the opposite x, bit by bit.
struct MirroredPair {
    Points2 a, b;  ///< #m x 2; the first corners mirror each other
    /// Row of each corner of the input outlines. Other rows are corners of the other outline, and
    /// ends of segments.
    std::vector<int> rowOfA, rowOfB;
};

/// An outline that is its own mirror image: row k and row #m - k, modulo #m, bit by bit.
struct SymmetricLine {
    Points2 line;          ///< #m x 2
    std::vector<int> row;  ///< row of each corner of the input outline
};

/// The mirror image, starting at the place `start`, anti-clockwise like the input. A place within
/// an edge becomes a corner.  Cost: linear. Pure.
Points2 mirroredLine(const Points2& line, double start);

/// The mean of one outline and the mirror image of another: averages their turning angles at equal
/// shares of each segment, and closes the outline with exact lengths as close to these means as
/// possible (boundary problem, [Wang05] eq. 9). Segments and edges keep their lengths, measured
/// along the line. An edge may bend where the other outline has a corner.
/// @param ends  ends of segments, at least one: in order along `a`, backwards along `b`. The
///              segments have equal lengths on both (`commonLengths`); else their means are used
/// Errors: those of solveBoundary.  Cost: n log n, and the boundary problem. Re-entrant.
Result<MirroredPair> meanLine(const Points2& a, const Points2& b,
                              const std::vector<MirrorEnd>& ends);

/// The same for an outline and its own mirror image.
/// @param from, to  the places where the mirror line crosses the outline, which halve its length:
///                  the first is placed at the origin, the other one above it
/// Errors and cost as for `meanLine`.
Result<SymmetricLine> symmetricLine(const Points2& line, double from, double to);

}  // namespace toile
