// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/diagnose/doubt.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "core/assemble/identify.h"
#include "core/base/characters.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/quality/measures.h"
#include "core/quality/metric_tensor.h"

namespace toile {
namespace {

constexpr double kPercent = 100;
constexpr double kSquareMillimetresPerSquareCentimetre = 100;

/// Absolute strain over a piece, weighted by area; 0.3 is 30 %.
struct StrainSizes {
    double mean = 0;    ///< of both principal directions; a triangle counts at most kMaxCounted
    double beyond = 0;  ///< share of the area beyond kStrainBeyondCloth in its worst direction
    double high = 0;    ///< exceeded on only kStrainFaultArea of the area
    int worst = -1;     ///< triangle
};

/// Limit per triangle, so that single stretched triangles do not decide the mean.
constexpr double kMaxCounted = 1;

StrainSizes strainSizes(const PieceResult& result) {
    const auto metrics = wornFaceMetrics(result.piece->mesh, result.flat->Q);
    // Flat cloth may have zero area.
    const Eigen::VectorXd areas = triangleAreas3d(result.piece->mesh);
    StrainSizes sizes;
    std::vector<std::pair<double, double>> sizeAndArea;
    double total = 0, worst = 0;
    for (Eigen::Index f = 0; f < areas.size(); ++f) {
        const PrincipalStretch stretch = principalStretch(metrics[static_cast<std::size_t>(f)]);
        const double one = std::abs(stretch.largest - 1), other = std::abs(stretch.least - 1);
        const double size = std::max(one, other);
        sizeAndArea.emplace_back(size, areas[f]);
        total += areas[f];
        sizes.mean += areas[f] * std::min((one + other) / 2, kMaxCounted);
        sizes.beyond += size > kStrainBeyondCloth ? areas[f] : 0;
        if (size > worst) {
            worst = size;
            sizes.worst = static_cast<int>(f);
        }
    }
    if (!(total > 0)) {
        return {};
    }
    sizes.mean /= total;
    sizes.beyond /= total;
    std::ranges::sort(sizeAndArea, std::greater<>());
    double passed = 0;
    for (const auto& [size, area] : sizeAndArea) {
        passed += area;
        if (passed > kStrainFaultArea * total) {
            sizes.high = size;
            break;
        }
    }
    return sizes;
}

/// No flat outline encloses more area than a circle of equal length. If that circle has less than
/// this share of a piece's area, the piece is nearly closed, like a hat or a sock.
constexpr double kNearlyClosed = 0.8;

Wording closedWords(const Piece& piece, const PieceQuality* quality) {
    const bool isNearlyClosed =
        quality != nullptr && quality->perimeter3d * quality->perimeter3d <
                                  kNearlyClosed * 4 * std::numbers::pi * quality->area3d;
    return isNearlyClosed && piece.holes.empty()
               ? worded(
                     "; the piece is nearly closed: its outline of %1 mm cannot lie flat around "
                     "its %2 cm²",
                     {figure(quality->perimeter3d),
                      figure(quality->area3d / kSquareMillimetresPerSquareCentimetre)})
               : Wording();
}

/// The largest limit of a fabric in any direction.
double largestLimit(const Fabric& fabric) {
    double largest = 0;
    for (const StrainLimits& limits : {fabric.warp, fabric.weft, fabric.bias}) {
        largest = std::max({largest, limits.most, -limits.least});
    }
    return largest;
}

std::optional<Finding> strainDoubt(const PieceResult& result, int index, const Fabric& fabric) {
    const Piece& piece = *result.piece;
    const StrainSizes sizes = strainSizes(result);
    const bool isFault = hasLimits(fabric)
                             ? sizes.high > std::max(kStrainBeyondCloth, largestLimit(fabric))
                             : sizes.high > kStrainBeyondCloth || sizes.mean > kMeanStrainFault;
    const bool isBeyond = sizes.beyond > kStrainBeyondClothShare;
    const double apart = result.flat->apartStrain;
    if (!isBeyond && !isFault && apart <= kApartStrain) {
        return std::nullopt;
    }
    Finding doubt{FindingKind::StrainBeyondCloth,
                  isFault ? Severity::Fault : Severity::Doubt,
                  subjectOf(piece),
                  {index}};
    if (sizes.worst >= 0) {
        doubt.place = placeInTriangle(piece, result.flat->Q, sizes.worst);
    }
    if (!isBeyond && !isFault) {
        doubt.badness = apart;
        doubt.reason = worded("moving its crossing outline apart adds %1 % strain",
                              {figure(kPercent * apart, 1)});
        return doubt;
    }
    doubt.badness = std::max(sizes.beyond, sizes.mean);
    const Wording mean = figure(kPercent * sizes.mean, 1);
    doubt.reason =
        isBeyond
            ? worded("strain exceeds %1 % on %2 % of the area, more than any fabric allows",
                     {figure(kPercent * kStrainBeyondCloth), figure(kPercent * sizes.beyond, 1)})
            : worded("strain is %1 % on average, which only stretch fabric allows", {mean});
    doubt.reason += closedWords(piece, result.quality ? &*result.quality : nullptr);
    return doubt;
}

std::optional<Finding> scrapsDoubt(const Garment& garment, const PieceResults& results) {
    int scraps = 0;
    for (std::size_t i = 0; i < garment.pieces.size(); ++i) {
        const bool isIn = i >= results.size() || !results[i] || !isLeftOut(*results[i]);
        scraps += isIn && triangleAreas3d(garment.pieces[i]->mesh).sum() < kScrapArea ? 1 : 0;
    }
    if (scraps <= kManyScraps) {
        return std::nullopt;
    }
    Finding doubt{FindingKind::ManyScraps, Severity::Doubt};
    doubt.badness = scraps;
    doubt.reason = worded("%1 of %2 pieces are smaller than 1 cm²",
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

std::optional<Finding> cutsDoubt(const CutRecord& record, const std::set<PieceId>& leftOut) {
    const auto isOut = [&leftOut](const auto& piece) { return leftOut.contains(piece->id); };
    if (!record.pieces.empty() && std::ranges::all_of(record.pieces, isOut)) {
        return std::nullopt;
    }
    double cuts = 0;
    for (const AppliedCut& cut : record.cuts) {
        // Cuts of the tailor have a reason.
        cuts += cut.author == CutAuthor::Automatic && cut.evidence.empty() ? cut.length : 0;
    }
    const std::vector<double> loops = loopLengths(*record.whole);
    const double outline = std::accumulate(loops.begin(), loops.end(), 0.0);
    if (outline <= 0 || cuts <= kLongCuts * outline) {
        return std::nullopt;
    }
    Finding doubt{FindingKind::LongCuts, Severity::Doubt, subjectOf(*record.whole)};
    doubt.badness = cuts / outline;
    doubt.reason = worded("its cuts are %1 mm long, longer than its outline of %2 mm",
                          {figure(cuts), figure(outline)});
    return doubt;
}

void addFileDoubts(const Garment& garment, std::vector<Finding>& doubts) {
    const std::vector<FileId> ids = fileIds(garment.files);
    const auto add = [&doubts](FindingKind kind, const Subject& subject, const Wording& reason) {
        Finding doubt{kind, Severity::Doubt, subject};
        doubt.reason = reason;
        doubts.push_back(std::move(doubt));
    };
    for (std::size_t f = 0; f < ids.size(); ++f) {
        const SourceFile& file = *garment.files[f];
        const Subject subject = Subject::file(pathText(file.path.filename()), ids[f]);
        if (file.upInDoubt) {
            add(FindingKind::UpAxisInDoubt, subject, file.upReason);
        }
        if (file.side.way == ClothSide::Way::Inwards) {
            add(FindingKind::InsideOut, subject, file.side.evidence);
        }
    }
}

}  // namespace

std::vector<Finding> findDoubts(const Garment& garment, const PieceResults& results,
                                const std::vector<Fabric>& fabrics) {
    std::vector<Finding> doubts;
    addFileDoubts(garment, doubts);
    const auto add = [&doubts](std::optional<Finding> doubt) {
        if (doubt) {
            doubts.push_back(std::move(*doubt));
        }
    };
    for (std::size_t i = 0; i < std::min(results.size(), garment.pieces.size()); ++i) {
        const PieceResult* result = results[i].get();
        if (result && result->flat && result->piece == garment.pieces[i]) {
            add(strainDoubt(*result, static_cast<int>(i),
                            i < fabrics.size() ? fabrics[i] : fabricPresets().front()));
        }
    }
    add(scrapsDoubt(garment, results));
    const std::set<PieceId> leftOut = leftOutOf(results);
    for (const CutRecord& record : garment.cutRecords) {
        add(cutsDoubt(record, leftOut));
    }
    return doubts;
}

bool hasFaults(const Garment& garment, const PieceResults& results,
               const std::vector<Finding>& doubts) {
    const auto isFaulty = [](const auto& result) {
        const bool isBad =
            result && result->quality &&
            (result->quality->flippedTriangles > 0 || result->quality->outlineCrossings > 0);
        return isBad || (result && result->error && !isLeftOut(*result));
    };
    return std::ranges::any_of(results, isFaulty) ||
           std::ranges::any_of(
               doubts, [](const Finding& doubt) { return doubt.severity == Severity::Fault; }) ||
           std::ranges::any_of(garment.problems,
                               [](const Error& problem) { return !isNote(problem.code); });
}

}  // namespace toile
