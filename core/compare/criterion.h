// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

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
    ReferenceRms,  ///< distance to the designer's panel (ReferenceFit), mm
    StrainMean,    ///< size of the edges' strain, a fraction
    StrainMax,     ///< of one edge, a fraction, as the next; above 0 is stretch
    StrainMin,
};
inline constexpr std::size_t kCriterionCount = 13;

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

}  // namespace toile
