// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/diagnose/doubt.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/quality/measures.h"
#include "core/quality/metric_tensor.h"

namespace toile {
namespace {

constexpr double kPercent = 100;

/// The strain of the direction that is worst off: 0.3 stretched, -0.3 shrunk by 30 %.
double worstStrain(const MetricTensor& metric) {
    const PrincipalStretch stretch = principalStretch(metric);
    const double stretched = stretch.largest - 1, shrunk = stretch.least - 1;
    return stretched >= -shrunk ? stretched : shrunk;
}

std::optional<Doubt> strainDoubt(const PieceResult& result, int index) {
    const Piece& piece = *result.piece;
    const auto metrics = wornFaceMetrics(piece.mesh, result.flat->Q);
    const Eigen::VectorXd areas = triangleAreas3d(piece.mesh);  // flat cloth may have none left
    double total = 0, beyond = 0, worst = 0;
    Doubt doubt{DoubtKind::StrainBeyondCloth, subjectOf(piece), index};
    for (Eigen::Index f = 0; f < areas.size(); ++f) {
        const double strain = worstStrain(metrics[static_cast<std::size_t>(f)]);
        total += areas[f];
        beyond += std::abs(strain) > kStrainBeyondCloth ? areas[f] : 0;
        if (std::abs(strain) > std::abs(worst)) {
            worst = strain;
            doubt.face = static_cast<int>(f);
        }
    }
    if (!(beyond > kStrainBeyondClothShare * total)) {
        return std::nullopt;
    }
    doubt.badness = beyond / total;
    doubt.what =
        worded("strain is beyond %1 % on %2 % of the area, which no cloth takes",
               {figure(kPercent * kStrainBeyondCloth), figure(kPercent * doubt.badness, 1)});
    return doubt;
}

std::optional<Doubt> scrapsDoubt(const Garment& garment, const PieceResults& results) {
    int scraps = 0;
    for (std::size_t i = 0; i < garment.pieces.size(); ++i) {
        const bool isIn = i >= results.size() || !results[i] || !isLeftOut(*results[i]);
        scraps += isIn && triangleAreas3d(garment.pieces[i]->mesh).sum() < kScrapArea ? 1 : 0;
    }
    if (scraps <= kManyScraps) {
        return std::nullopt;
    }
    Doubt doubt{DoubtKind::ManyScraps};
    doubt.badness = scraps;
    doubt.what = worded("%1 of %2 pieces are smaller than 1 cm²",
                        {figure(scraps), figure(static_cast<double>(garment.pieces.size()))});
    return doubt;
}

/// Pieces that are left out of the pattern.
std::set<PieceId> leftOutOf(const PieceResults& results) {
    std::set<PieceId> pieces;
    for (const auto& result : results) {
        if (result && isLeftOut(*result)) {
            pieces.insert(result->piece->id);
        }
    }
    return pieces;
}

std::optional<Doubt> cutsDoubt(const CutRecord& record, const std::set<PieceId>& leftOut) {
    const auto isOut = [&leftOut](const auto& piece) { return leftOut.contains(piece->id); };
    if (!record.pieces.empty() && std::ranges::all_of(record.pieces, isOut)) {
        return std::nullopt;
    }
    double cuts = 0;
    for (const AppliedCut& cut : record.cuts) {
        // A tailor's have a reason.
        cuts += cut.author == CutAuthor::Automatic && cut.evidence.empty() ? cut.length : 0;
    }
    const std::vector<double> loops = loopLengths(*record.whole);
    const double outline = std::accumulate(loops.begin(), loops.end(), 0.0);
    if (outline <= 0 || cuts <= kLongCuts * outline) {
        return std::nullopt;
    }
    Doubt doubt{DoubtKind::LongCuts, subjectOf(*record.whole)};
    doubt.badness = cuts / outline;
    doubt.what = worded("its cuts are %1 mm long, longer than its outline of %2 mm",
                        {figure(cuts), figure(outline)});
    return doubt;
}

}  // namespace

const DoubtWords& doubtWords(DoubtKind kind) {
    return kDoubtWords[static_cast<std::size_t>(kind)];
}

std::string sentence(const Doubt& doubt) {
    std::string text =
        doubt.subject.name.empty() ? "" : shownText(doubt.subject.name, kMaxOfPlace) + ": ";
    std::string advice = doubtWords(doubt.kind).advice;
    advice.front() = lowered(advice.front());
    return text + doubt.what + "; " + advice + ".";
}

std::vector<Doubt> findDoubts(const Garment& garment, const PieceResults& results) {
    std::vector<Doubt> doubts;
    const auto add = [&doubts](std::optional<Doubt> doubt) {
        if (doubt) {
            doubts.push_back(std::move(*doubt));
        }
    };
    for (std::size_t i = 0; i < std::min(results.size(), garment.pieces.size()); ++i) {
        const PieceResult* result = results[i].get();
        if (result && result->flat && result->piece == garment.pieces[i]) {
            add(strainDoubt(*result, static_cast<int>(i)));
        }
    }
    add(scrapsDoubt(garment, results));
    const std::set<PieceId> leftOut = leftOutOf(results);
    for (const CutRecord& record : garment.cutRecords) {
        add(cutsDoubt(record, leftOut));
    }
    return doubts;
}

}  // namespace toile
