// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/compare/criterion.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"

namespace toile {

/// What one method makes of one piece, or of all pieces of a garment. A value is empty where there
/// is nothing to measure, or where it is infinite.
struct ComparedFigures {
    int pieces = 0;            ///< that were tried
    int failed = 0;            ///< that did not become flat; the figures are of those that did
    int referencedPieces = 0;  ///< flat pieces that carry their designer's panel
    std::array<std::optional<double>, kCriterionCount> values{};

    std::optional<double>& operator[](Criterion criterion) {
        return values[static_cast<std::size_t>(criterion)];
    }
    const std::optional<double>& operator[](Criterion criterion) const {
        return values[static_cast<std::size_t>(criterion)];
    }
};

/// One method's column in the comparison.
struct ComparedMethod {
    Method method;
    PieceResults results;  ///< one per piece of the garment, in its order
    ComparedFigures figures;
    std::vector<ComparedFigures> pieceFigures;  ///< per piece; seams: those that the piece has
};

/// One garment under several methods, in the order in which they were asked for.
struct Comparison {
    std::vector<ComparedMethod> methods;
};

/// Aggregates one method's results. @param results one per piece of the garment, in its order
/// Cost: that of measuring every seam once. Pure.
ComparedMethod compared(Method method, const Garment& garment, PieceResults results);

/// One of `ComparedMethod::pieceFigures`, for whom the rest of the garment is of no interest.
/// @param results  one per piece of the garment, null where it was not flattened; that of `piece`
///                 is there. Seams to a piece that is not flat are left out
/// Cost: that of measuring the piece's seams once. Pure.
ComparedFigures comparedPiece(const Garment& garment, const PieceResults& results, int piece);

/// The other pieces that share a seam with this one, ascending: what it takes, besides the piece
/// itself, to know its seams. Cost: negligible. Pure.
std::vector<int> sewnTo(const Garment& garment, int piece);

/// Methods with a free outline that come nearer to the designer's panels than every method that
/// keeps seam lengths, and the nearest of those. Only methods that made every panel flat which any
/// method did are looked at. Indices into `methods`.
struct NearerMethods {
    std::vector<std::size_t> freeOutline;  ///< nearest first; never empty
    std::size_t lengthKeeping = 0;
};

/// Nothing where no free outline is nearer, or there is nothing to compare with. Pure.
std::optional<NearerMethods> nearerThanLengthKeeping(const Comparison& comparison);

}  // namespace toile
