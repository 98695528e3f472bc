// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/garment/garment.h"
#include "core/mesh/mesh_arrays.h"
#include "core/symmetry/mirror_plane.h"

namespace toile {

/// Pairs of pieces that are mirror images.
struct MirrorPieces {
    /// Per piece: its mirror image, itself if it is symmetric, or -1.
    std::vector<int> counterpart;
    /// Per piece: root mean square distance, over the area, between the reflected piece and its
    /// counterpart, in both directions, mm; the same for both. 0 without a counterpart.
    std::vector<double> deviation;
};

/// A piece's counterpart is the piece that most of its area is nearest to after reflection, if the
/// reverse holds too.
/// Precondition: finite positions. Deterministic.
/// @param progress  polled for each vertex; after a cancel the result is empty
/// Cost: O(log #F) for each of at most 20 000 vertices, twice.  Pure.
MirrorPieces pairPieces(const Garment& garment, const MirrorPlane& plane,
                        const Progress& progress = {});

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
