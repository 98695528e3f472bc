// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"

namespace toile {

/// Criteria for comparing methods: the columns of [Wang05] Table 1 and further ones for pattern
/// makers. In the order of the reports.
enum class Criterion {
    Seconds,  ///< of the solves alone, without reading and measuring
    PiTheta,  ///< radians
    PiE,
    PiA,
    SymmetricDirichlet,  ///< nothing if any triangle is flipped or collapsed
    LengthError,         ///< largest of an outline edge, a fraction
    FlippedTriangles,
    OutlineCrossings,
    /// Largest |error| of a seam whose two sides are flat, without ease (SeamMeasure), mm.
    SeamMismatch,
    ReferenceRms,  ///< distance to the reference panel (ReferenceFit), mm
    /// Mean distance between the design and the pattern sewn back together, mm; filled in by the
    /// caller that runs the proof.
    SewnGap,
    StrainMean,  ///< mean size of the edges' strain, a fraction
    StrainMax,   ///< of one edge, a fraction, as the next; above 0 is stretch
    StrainMin,
};
inline constexpr std::size_t kCriterionCount = 14;

/// How a figure is written.
enum class FigureFormat { Seconds, Ratio, SignedRatio, LengthError, Count, Millimetres };

/// How the figure of a garment is computed from those of its flat pieces.
enum class Aggregate {
    PieceOnly,    ///< not defined for a garment
    Sum,          ///< pieces are solved in parallel: wall time may be less
    Largest,      ///< of the pieces that have one
    Mean,         ///< over pieces; nothing if any piece lacks it, as the next
    MeanByArea,   ///< weighted by 3D area
    KnownByArea,  ///< the same over the pieces that have one
};

/// Properties of a criterion for the reports, the command line and the window.
struct CriterionTraits {
    Criterion criterion;
    FigureFormat format;
    Aggregate aggregate;
    bool isOptional;        ///< text tables omit it if no method has a figure
    std::string_view key;   ///< in JSON (docs/comparison.md); empty if it is not listed
    std::string_view head;  ///< of its column in a text table; empty if it has none
    /// For the window, to be translated; "%1" is the unit of lengths; null if it is not shown.
    const char* title;
    const char* tip;
};

/// In the order of `Criterion`.
std::span<const CriterionTraits> allCriteria();
const CriterionTraits& traits(Criterion criterion);

/// Index of the best figure, the first of equals; nothing without figures. Lower is better; for the
/// largest stretch and surplus only values on their own side of 0 count. Pure.
std::optional<std::size_t> bestOf(Criterion criterion,
                                  std::span<const std::optional<double>> values);

/// Figures of one method for one piece, or for all pieces of a garment. A value is empty if it
/// cannot be measured or is infinite.
struct ComparedFigures {
    int pieces = 0;            ///< attempted pieces, without pieces that are left out
    int failed = 0;            ///< pieces that did not become flat; the figures cover the others
    int referencedPieces = 0;  ///< flat pieces that have a reference panel
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
    std::vector<ComparedFigures> pieceFigures;  ///< per piece, with all seams of the piece
};

/// One garment under several methods, in the requested order.
struct Comparison {
    std::vector<ComparedMethod> methods;
};

/// Aggregates one method's results. @param results one per piece of the garment, in its order
/// Cost: that of measuring every seam once. Pure.
ComparedMethod compared(Method method, const Garment& garment, PieceResults results);

/// One of `ComparedMethod::pieceFigures`, without computing the rest of the garment.
/// @param results  one per piece of the garment, null if it was not flattened; that of `piece` must
///                 exist. Seams to a piece that is not flat are left out
/// Cost: that of measuring the piece's seams once. Pure.
ComparedFigures comparedPiece(const Garment& garment, const PieceResults& results, int piece);

/// The other pieces that share a seam with this one, ascending: the pieces needed to measure its
/// seams. Cost: negligible. Pure.
std::vector<int> sewnTo(const Garment& garment, int piece);

/// Methods with a free outline that are closer to the reference panels than every method that keeps
/// seam lengths, and the closest of the latter. Considers only methods that flattened every panel
/// that any method did. Indices into `methods`.
struct NearerMethods {
    std::vector<std::size_t> freeOutline;  ///< nearest first; never empty
    std::size_t lengthKeeping = 0;
};

/// Nothing if no free outline is closer, or there is nothing to compare with. Pure.
std::optional<NearerMethods> nearerThanLengthKeeping(const Comparison& comparison);

}  // namespace toile
