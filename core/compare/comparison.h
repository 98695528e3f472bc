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

/// What methods are compared by: the columns of [Wang05] Table 1 and what a pattern maker asks
/// besides. In the order of the reports.
enum class Criterion {
    Seconds,  ///< of the solves alone, reading and measuring aside
    PiTheta,  ///< radians
    PiE,
    PiA,
    SymmetricDirichlet,  ///< nothing where one triangle is flipped or collapsed
    LengthError,         ///< largest of an edge of the outline, a fraction
    FlippedTriangles,
    OutlineCrossings,
    /// Largest |error| of a seam whose two sides are flat, its ease taken out (SeamMeasure), mm.
    SeamMismatch,
    ReferenceRms,  ///< distance to the reference panel (ReferenceFit), mm
    /// Mean distance of the pattern, sewn back together, from the design, mm; who has it proved
    /// fills it in.
    SewnGap,
    StrainMean,  ///< size of the edges' strain, a fraction
    StrainMax,   ///< of one edge, a fraction, as the next; above 0 is stretch
    StrainMin,
};
inline constexpr std::size_t kCriterionCount = 14;

/// How a figure is written.
enum class FigureFormat { Seconds, Ratio, SignedRatio, LengthError, Count, Millimetres };

/// How the figure of a garment follows from those of its flat pieces.
enum class Aggregate {
    PieceOnly,    ///< it has none
    Sum,          ///< pieces are solved side by side: of seconds the clock may show less
    Largest,      ///< of the pieces that have one
    Mean,         ///< over pieces; nothing where one has none, as the next
    MeanByArea,   ///< weighted by 3D area
    KnownByArea,  ///< the same over the pieces that have one
};

/// What the reports, the command line and the window need to know of a criterion.
struct CriterionTraits {
    Criterion criterion;
    FigureFormat format;
    Aggregate aggregate;
    bool isOptional;        ///< text tables leave it out where no method has a figure
    std::string_view key;   ///< in JSON (docs/report.md); empty where it is not there
    std::string_view head;  ///< of its column in a text table; empty where it is not there
    /// For the window, to be translated, "%1" the unit of lengths; null where it is not shown.
    const char* title;
    const char* tip;
};

/// In the order of `Criterion`.
std::span<const CriterionTraits> allCriteria();
const CriterionTraits& traits(Criterion criterion);

/// The best of several figures, the first of equals; nothing where there is none. Less is better;
/// of the largest stretch and surplus only what lies on its own side of 0 counts. Pure.
std::optional<std::size_t> bestOf(Criterion criterion,
                                  std::span<const std::optional<double>> values);

/// What one method makes of one piece, or of all pieces of a garment. A value is empty where there
/// is nothing to measure, or where it is infinite.
struct ComparedFigures {
    int pieces = 0;            ///< that were tried: left out are not
    int failed = 0;            ///< that did not become flat; the figures are of those that did
    int referencedPieces = 0;  ///< flat pieces that carry their reference panel
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

/// Methods with a free outline that come nearer to the reference panels than every method that
/// keeps seam lengths, and the nearest of those. Only methods that made every panel flat which any
/// method did are looked at. Indices into `methods`.
struct NearerMethods {
    std::vector<std::size_t> freeOutline;  ///< nearest first; never empty
    std::size_t lengthKeeping = 0;
};

/// Nothing where no free outline is nearer, or there is nothing to compare with. Pure.
std::optional<NearerMethods> nearerThanLengthKeeping(const Comparison& comparison);

}  // namespace toile
