// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/sew/cloth.h"

namespace toile::sew {

/// A piece of a pattern in the triangles of the garment's piece.
struct PatternPart {
    Points2 flat;                        ///< per vertex of the piece, mm; none: it is left out
    double warp = std::numbers::pi / 2;  ///< direction of the warp, radians from x
};

/// The pattern that came out; pieces that are not flat have no points.
std::vector<PatternPart> partsOf(const PieceResults& results);
/// The designer's own, where the file carries it.
std::vector<PatternPart> referenceParts(const Garment& garment);

/// A garment's pieces with what is sewn to what along its seams: as the two sides are matched, that
/// is by arc length with ease spread evenly. Where vertices of the two sides lie across from each
/// other they are sewn; where one has none across, the triangle there is divided at that place, in
/// space and in the pattern alike. Two closer than a twentieth of their edges count as across.
/// @param parts  one per piece  Cost: linear in the triangles, n log n in the seams. Pure.
/// Errors: NoGeometry, where no piece is flat.
Result<CutCloth> cutAlongSeams(const Garment& garment, const std::vector<PatternPart>& parts);

}  // namespace toile::sew
