// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/criterion.h"

#include <algorithm>
#include <array>

#include "core/base/wording.h"

namespace toile {
namespace {

constexpr std::array<CriterionTraits, kCriterionCount> kCriteria = {{
    {Criterion::Seconds, FigureFormat::Seconds, Aggregate::Sum, false, "seconds", "time ms",
     translatable("Time, ms"),
     translatable("What the solver took for this piece, when it solved it last")},
    {Criterion::PiTheta, FigureFormat::Ratio, Aggregate::Mean, false, "pi_theta", "Pi_theta",
     nullptr, nullptr},
    {Criterion::PiE, FigureFormat::Ratio, Aggregate::Mean, false, "pi_e", "Pi_E", nullptr, nullptr},
    {Criterion::PiA, FigureFormat::Ratio, Aggregate::Mean, false, "pi_a", "Pi_A",
     translatable("Area error, %"),
     translatable("How much of the area has gone to other triangles: 0 where each has its share of "
                  "the whole, as in the garment")},
    {Criterion::SymmetricDirichlet, FigureFormat::Ratio, Aggregate::MeanByArea, false,
     "symmetric_dirichlet", "SD", nullptr, nullptr},
    {Criterion::LengthError, FigureFormat::LengthError, Aggregate::Largest, false,
     "max_boundary_length_error", "length error", translatable("Outline length error, %"),
     translatable("The edge of the outline whose length has changed most")},
    {Criterion::FlippedTriangles, FigureFormat::Count, Aggregate::Sum, false, "flipped_triangles",
     "flips", translatable("Flipped triangles"),
     translatable("Triangles that are turned over: cloth cannot do that")},
    {Criterion::OutlineCrossings, FigureFormat::Count, Aggregate::Sum, false, "outline_crossings",
     "crossings", translatable("Outline crossings"),
     translatable("Where the outline crosses itself")},
    {Criterion::SeamMismatch, FigureFormat::Millimetres, Aggregate::Largest, true,
     "seam_mismatch_mm", "seam mm", translatable("Seam Δ, %1"),
     translatable("The worst seam of this piece: by how much its two flat sides miss each other, "
                  "the ease taken out")},
    {Criterion::ReferenceRms, FigureFormat::Millimetres, Aggregate::KnownByArea, true,
     "reference_rms_mm", "rms mm", translatable("To the designer’s panel, %1"),
     translatable("Distance to the panel that the file carries, laid on each other as well as may "
                  "be; root mean square")},
    {Criterion::StrainMean, FigureFormat::Ratio, Aggregate::PieceOnly, false, "", "",
     translatable("Mean strain, %"),
     translatable("How far the cloth must stretch or gather, on the mean of all edges of the "
                  "mesh")},
    {Criterion::StrainMax, FigureFormat::SignedRatio, Aggregate::PieceOnly, false, "", "",
     translatable("Most stretch, %"),
     translatable("The edge of the mesh that must stretch most to take its worn shape")},
    {Criterion::StrainMin, FigureFormat::SignedRatio, Aggregate::PieceOnly, false, "", "",
     translatable("Most surplus, %"),
     translatable("The edge of the mesh that must gather most to take its worn shape")},
}};

/// Stretch does not make up for surplus elsewhere: each counts on its own side of 0 alone.
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
