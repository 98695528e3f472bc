// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/comparison.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/seam/seam_fit.h"

namespace toile {
namespace {

std::optional<double> finite(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? value : std::nullopt;
}

ComparedFigures figuresOf(const PieceResult& result) {
    ComparedFigures figures;
    figures.pieces = 1;
    if (!result.flat || !result.quality) {
        figures.failed = 1;
        return figures;
    }
    const PieceQuality& q = *result.quality;
    figures.seconds = result.flat->boundarySeconds + result.flat->interiorSeconds;
    figures.piTheta = finite(q.piTheta);
    figures.piE = finite(q.piE);
    figures.piA = finite(q.piA);
    figures.symmetricDirichlet = finite(q.symmetricDirichlet);
    figures.maxBoundaryLengthError = finite(q.maxBoundaryLengthError);
    figures.flippedTriangles = q.flippedTriangles;
    figures.outlineCrossings = q.outlineCrossings;
    if (q.reference) {
        figures.referencedPieces = 1;
        figures.referenceRms = q.reference->rms;
    }
    return figures;
}

void takeLargest(std::optional<double>& largest, double value) {
    largest = std::max(largest.value_or(value), value);
}

/// How far the two flat sides of a seam are from fitting, the ease taken out; nothing where there
/// are not two.
std::optional<double> mismatchOf(const Garment& garment, const PieceResults& results,
                                 std::size_t seam) {
    const auto measure = measured(garment, results, static_cast<int>(seam));
    const bool isSewn = garment.seams.seams[seam].kind != SeamKind::Free;
    return measure && isSewn ? std::optional(std::abs(measure->errorMm)) : std::nullopt;
}

/// Notes the mismatch of every seam at the garment and at the pieces that it joins.
void measureSeams(const Garment& garment, ComparedMethod& method) {
    for (std::size_t k = 0; k < garment.seams.seams.size(); ++k) {
        const Seam& seam = garment.seams.seams[k];
        if (const auto mismatch = mismatchOf(garment, method.results, k)) {
            takeLargest(method.figures.seamMismatch, *mismatch);
            takeLargest(method.pieceFigures[seam.left.piece].seamMismatch, *mismatch);
            takeLargest(method.pieceFigures[seam.right.piece].seamMismatch, *mismatch);
        }
    }
}

/// A weighted mean that one missing value spoils.
class Mean {
public:
    void add(const std::optional<double>& value, double weight) {
        complete_ = complete_ && value;
        sum_ += weight * value.value_or(0);
        weights_ += weight;
    }

    std::optional<double> value() const {
        return complete_ && weights_ > 0 ? std::optional(sum_ / weights_) : std::nullopt;
    }

private:
    double sum_ = 0, weights_ = 0;
    bool complete_ = true;
};

void aggregate(ComparedMethod& method) {
    ComparedFigures& whole = method.figures;
    Mean piTheta, piE, piA, dirichlet, rms;
    for (std::size_t k = 0; k < method.results.size(); ++k) {
        const ComparedFigures& piece = method.pieceFigures[k];
        ++whole.pieces;
        whole.failed += piece.failed;
        if (piece.failed > 0) {
            continue;
        }
        const double area = method.results[k]->quality->area3d;
        whole.seconds += piece.seconds;
        piTheta.add(piece.piTheta, 1);
        piE.add(piece.piE, 1);
        piA.add(piece.piA, 1);
        dirichlet.add(piece.symmetricDirichlet, area);
        if (piece.maxBoundaryLengthError) {
            takeLargest(whole.maxBoundaryLengthError, *piece.maxBoundaryLengthError);
        }
        whole.flippedTriangles += piece.flippedTriangles;
        whole.outlineCrossings += piece.outlineCrossings;
        whole.referencedPieces += piece.referencedPieces;
        if (piece.referenceRms) {
            rms.add(piece.referenceRms, area);
        }
    }
    whole.piTheta = piTheta.value();
    whole.piE = piE.value();
    whole.piA = piA.value();
    whole.symmetricDirichlet = dirichlet.value();
    whole.referenceRms = rms.value();
}

/// Whether the method made the piece flat and the piece carries its designer's panel.
bool hasPanel(const ComparedMethod& method, std::size_t piece) {
    return piece < method.pieceFigures.size() && method.pieceFigures[piece].referencedPieces > 0;
}

/// Whether the method has every panel that any method has: a mean over others is no match.
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
    aggregate(made);
    measureSeams(garment, made);
    return made;
}

ComparedFigures comparedPiece(const Garment& garment, const PieceResults& results, int piece) {
    ComparedFigures figures = figuresOf(*results[static_cast<std::size_t>(piece)]);
    for (std::size_t k = 0; k < garment.seams.seams.size(); ++k) {
        const Seam& seam = garment.seams.seams[k];
        if (seam.left.piece == piece || seam.right.piece == piece) {
            if (const auto mismatch = mismatchOf(garment, results, k)) {
                takeLargest(figures.seamMismatch, *mismatch);
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
    const auto rms = [&methods](std::size_t k) { return *methods[k].figures.referenceRms; };
    std::optional<std::size_t> best;
    std::vector<std::size_t> nearer;
    for (std::size_t k = 0; k < methods.size(); ++k) {
        if (!methods[k].figures.referenceRms || !hasAllPanels(methods[k], methods)) {
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

}  // namespace toile
