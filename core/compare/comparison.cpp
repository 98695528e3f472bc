// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/base/wording.h"
#include "core/seam/seam_measure.h"

namespace toile {
namespace {

ComparedFigures figuresOf(const PieceResult& result) {
    ComparedFigures figures;
    figures.pieces = isLeftOut(result) ? 0 : 1;
    if (!result.flat || !result.quality) {
        figures.failed = figures.pieces;
        return figures;
    }
    const PieceQuality& q = *result.quality;
    figures[Criterion::Seconds] = result.flat->boundarySeconds + result.flat->interiorSeconds;
    figures[Criterion::PiTheta] = q.piTheta;
    figures[Criterion::PiE] = q.piE;
    figures[Criterion::PiA] = q.piA;
    figures[Criterion::SymmetricDirichlet] = q.symmetricDirichlet;
    figures[Criterion::LengthError] = q.maxBoundaryLengthError;
    figures[Criterion::FlippedTriangles] = q.flippedTriangles;
    figures[Criterion::OutlineCrossings] = q.outlineCrossings;
    figures[Criterion::StrainMean] = q.strainMeanAbs;
    figures[Criterion::StrainMax] = q.strainMax;
    figures[Criterion::StrainMin] = q.strainMin;
    if (q.reference) {
        figures.referencedPieces = 1;
        figures[Criterion::ReferenceRms] = q.reference->rms;
    }
    for (std::optional<double>& value : figures.values) {
        value = value && std::isfinite(*value) ? value : std::nullopt;
    }
    return figures;
}

void takeLargest(std::optional<double>& largest, double value) {
    largest = std::max(largest.value_or(value), value);
}

/// Mismatch of the two flat sides of a seam, without the ease; nothing unless both sides are flat.
std::optional<double> mismatchOf(const Garment& garment, const PieceResults& results,
                                 std::size_t seam) {
    const auto measure = measured(garment, results, static_cast<int>(seam));
    const bool isSewn = garment.seams.seams[seam].kind != SeamKind::Free;
    return measure && isSewn ? std::optional(std::abs(measure->errorMm)) : std::nullopt;
}

/// Stores the mismatch of every seam with the pieces that it joins.
void measureSeams(const Garment& garment, ComparedMethod& method) {
    for (std::size_t k = 0; k < garment.seams.seams.size(); ++k) {
        const Seam& seam = garment.seams.seams[k];
        if (const auto mismatch = mismatchOf(garment, method.results, k)) {
            takeLargest(method.pieceFigures[seam.left.piece][Criterion::SeamMismatch], *mismatch);
            takeLargest(method.pieceFigures[seam.right.piece][Criterion::SeamMismatch], *mismatch);
        }
    }
}

/// One figure of the whole garment, aggregated over its flat pieces.
std::optional<double> aggregated(const CriterionTraits& criterion, const ComparedMethod& method) {
    if (criterion.aggregate == Aggregate::PieceOnly) {
        return std::nullopt;
    }
    const bool isByArea = criterion.aggregate == Aggregate::MeanByArea ||
                          criterion.aggregate == Aggregate::KnownByArea;
    const bool isSpoiled =  // by a piece without the figure
        criterion.aggregate == Aggregate::Mean || criterion.aggregate == Aggregate::MeanByArea;
    double sum = 0, weights = 0;
    std::optional<double> largest;
    for (std::size_t k = 0; k < method.results.size(); ++k) {
        const std::optional<double>& value = method.pieceFigures[k][criterion.criterion];
        const bool isFlat = method.pieceFigures[k].pieces > method.pieceFigures[k].failed;
        if (!isFlat || (!value && !isSpoiled)) {
            continue;
        }
        if (!value) {
            return std::nullopt;
        }
        const double weight = isByArea ? method.results[k]->quality->area3d : 1;
        sum += weight * *value;
        weights += weight;
        takeLargest(largest, *value);
    }
    if (criterion.aggregate == Aggregate::Largest) {
        return largest;
    }
    if (weights <= 0) {
        return std::nullopt;
    }
    return criterion.aggregate == Aggregate::Sum ? sum : sum / weights;
}

/// Whether the method flattened the piece and the piece has a reference panel.
bool hasPanel(const ComparedMethod& method, std::size_t piece) {
    return piece < method.pieceFigures.size() && method.pieceFigures[piece].referencedPieces > 0;
}

/// Whether the method has every panel that any method has: means over other panels do not compare.
bool hasAllPanels(const ComparedMethod& method, const std::vector<ComparedMethod>& methods) {
    return std::ranges::all_of(methods, [&method](const ComparedMethod& other) {
        for (std::size_t piece = 0; piece < other.pieceFigures.size(); ++piece) {
            if (hasPanel(other, piece) && !hasPanel(method, piece)) {
                return false;
            }
        }
        return true;
    });
}

}  // namespace

ComparedMethod compared(Method method, const Garment& garment, PieceResults results) {
    ComparedMethod made{method, std::move(results), {}, {}};
    for (const auto& result : made.results) {
        made.pieceFigures.push_back(figuresOf(*result));
    }
    measureSeams(garment, made);
    for (const ComparedFigures& piece : made.pieceFigures) {
        made.figures.pieces += piece.pieces;
        made.figures.failed += piece.failed;
        made.figures.referencedPieces += piece.referencedPieces;
    }
    for (const CriterionTraits& criterion : allCriteria()) {
        made.figures[criterion.criterion] = aggregated(criterion, made);
    }
    return made;
}

ComparedFigures comparedPiece(const Garment& garment, const PieceResults& results, int piece) {
    ComparedFigures figures = figuresOf(*results[static_cast<std::size_t>(piece)]);
    for (std::size_t k = 0; k < garment.seams.seams.size(); ++k) {
        const Seam& seam = garment.seams.seams[k];
        if (seam.left.piece == piece || seam.right.piece == piece) {
            if (const auto mismatch = mismatchOf(garment, results, k)) {
                takeLargest(figures[Criterion::SeamMismatch], *mismatch);
            }
        }
    }
    return figures;
}

std::vector<int> sewnTo(const Garment& garment, int piece) {
    std::set<int> others;
    for (const Seam& seam : garment.seams.seams) {
        if (seam.kind != SeamKind::Free &&
            (seam.left.piece == piece || seam.right.piece == piece)) {
            others.insert({seam.left.piece, seam.right.piece});
        }
    }
    others.erase(piece);
    return {others.begin(), others.end()};
}

std::optional<NearerMethods> nearerThanLengthKeeping(const Comparison& comparison) {
    const auto& methods = comparison.methods;
    const auto rms = [&methods](std::size_t k) {
        return *methods[k].figures[Criterion::ReferenceRms];
    };
    std::optional<std::size_t> best;
    std::vector<std::size_t> nearer;
    for (std::size_t k = 0; k < methods.size(); ++k) {
        if (!methods[k].figures[Criterion::ReferenceRms] || !hasAllPanels(methods[k], methods)) {
            continue;
        }
        if (!traits(methods[k].method).keepsLengths) {
            nearer.push_back(k);
        } else if (!best || rms(k) < rms(*best)) {
            best = k;
        }
    }
    if (!best) {
        return std::nullopt;
    }
    std::erase_if(nearer, [&](std::size_t k) { return rms(k) >= rms(*best); });
    std::ranges::stable_sort(nearer, {}, rms);
    return nearer.empty() ? std::nullopt : std::optional(NearerMethods{nearer, *best});
}

namespace {

constexpr std::array<CriterionTraits, kCriterionCount> kCriteria = {{
    {Criterion::Seconds, FigureFormat::Seconds, Aggregate::Sum, false, "seconds", "time ms",
     translatable("Time, ms"), translatable("Time of the last solve of this piece")},
    {Criterion::PiTheta, FigureFormat::Ratio, Aggregate::Mean, false, "pi_theta", "Pi_theta",
     nullptr, nullptr},
    {Criterion::PiE, FigureFormat::Ratio, Aggregate::Mean, false, "pi_e", "Pi_E", nullptr, nullptr},
    {Criterion::PiA, FigureFormat::Ratio, Aggregate::Mean, false, "pi_a", "Pi_A",
     translatable("Area error, %"),
     translatable("Share of the area that moved to other triangles; 0 if each keeps its share of "
                  "the garment")},
    {Criterion::SymmetricDirichlet, FigureFormat::Ratio, Aggregate::MeanByArea, false,
     "symmetric_dirichlet", "SD", nullptr, nullptr},
    {Criterion::LengthError, FigureFormat::LengthError, Aggregate::Largest, false,
     "max_boundary_length_error", "length error", translatable("Outline length error, %"),
     translatable("Largest change in length of an outline edge")},
    {Criterion::FlippedTriangles, FigureFormat::Count, Aggregate::Sum, false, "flipped_triangles",
     "flips", translatable("Flipped triangles"),
     translatable("Triangles whose orientation is reversed in the pattern; cloth cannot do that")},
    {Criterion::OutlineCrossings, FigureFormat::Count, Aggregate::Sum, false, "outline_crossings",
     "crossings", translatable("Outline crossings"),
     translatable("Number of places where the outline crosses itself")},
    {Criterion::SeamMismatch, FigureFormat::Millimetres, Aggregate::Largest, true,
     "seam_mismatch_mm", "seam mm", translatable("Seam Δ, %1"),
     translatable(
         "Largest difference between the two flat sides of a seam of this piece, beyond the ease")},
    {Criterion::ReferenceRms, FigureFormat::Millimetres, Aggregate::KnownByArea, true,
     "reference_rms_mm", "rms mm", translatable("Distance to reference panel, %1"),
     translatable("Root mean square distance to the panel in the file, after the best fit")},
    {Criterion::SewnGap, FigureFormat::Millimetres, Aggregate::KnownByArea, true, "sewn_gap_mm",
     "sewn gap mm", nullptr, nullptr},
    {Criterion::StrainMean, FigureFormat::Ratio, Aggregate::PieceOnly, false, "", "",
     translatable("Mean strain, %"),
     translatable("Stretch or surplus of the cloth, averaged over all mesh edges")},
    {Criterion::StrainMax, FigureFormat::SignedRatio, Aggregate::PieceOnly, false, "", "",
     translatable("Max. stretch, %"),
     translatable("Largest stretch of a mesh edge from the pattern to the garment")},
    {Criterion::StrainMin, FigureFormat::SignedRatio, Aggregate::PieceOnly, false, "", "",
     translatable("Max. surplus, %"),
     translatable("Largest surplus of a mesh edge from the pattern to the garment")},
}};

/// Stretch does not compensate for surplus elsewhere: each counts only on its own side of 0.
double badness(Criterion criterion, double value) {
    return criterion == Criterion::StrainMax   ? std::max(0.0, value)
           : criterion == Criterion::StrainMin ? std::max(0.0, -value)
                                               : value;
}

}  // namespace

std::span<const CriterionTraits> allCriteria() {
    return kCriteria;
}

const CriterionTraits& traits(Criterion criterion) {
    return kCriteria[static_cast<std::size_t>(criterion)];
}

std::optional<std::size_t> bestOf(Criterion criterion,
                                  std::span<const std::optional<double>> values) {
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (values[k] &&
            (!best || badness(criterion, *values[k]) < badness(criterion, *values[*best]))) {
            best = k;
        }
    }
    return best;
}

}  // namespace toile
