// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/drawn_outline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/statistics.h"
#include "core/geometry/line.h"
#include "core/pattern/mirrored_lines.h"
#include "core/pattern/reshaped_outline.h"
#include "core/pattern/segments.h"
#include "core/pattern/trueing.h"

namespace toile {
namespace {

/// Turn points this near to mirrored places are mirror images, mm.
constexpr double kSameTurnPoint = 1e-2;

/// The results with mirrored outlines, on which corners are searched for; the interior stays
/// unchanged.
PieceResults withMirroredOutlines(PieceResults results, const std::vector<MirrorPlan>& mirrors) {
    for (std::size_t p = 0; p < results.size(); ++p) {
        if (mirrors[p].lead < 0) {
            continue;
        }
        const MirroredOutline& outline = mirrors[p].outline;
        if (const auto line = mirroredFor(outline, lineOf(outline.reference))) {
            auto mirrored = std::make_shared<PieceResult>(*results[p]);
            const std::vector<int>& boundary = mirrored->piece->boundary;
            mirrored->flat->Q(boundary, Eigen::all) = verticesOn(*line, *mirrored->piece);
            results[p] = std::move(mirrored);
        }
    }
    return results;
}

/// A turn point of a leading piece and its mirror image.
struct MirroredPoint {
    int lead = -1, point = -1;
    int piece = -1, image = -1;
};

std::vector<MirroredPoint> mirroredPoints(const std::vector<MirrorPlan>& mirrors,
                                          const std::vector<OutlineSegments>& segments) {
    std::vector<MirroredPoint> found;
    for (int p = 0; p < static_cast<int>(mirrors.size()); ++p) {
        const auto& [lead, outline] = mirrors[p];
        if (lead < 0 || !(outline.isImage || outline.isSymmetric)) {
            continue;
        }
        const double turn = outline.places.falling.front() - outline.places.falling.back();
        const auto& from = segments[lead].turnPoints;
        const auto& to = segments[p].turnPoints;
        for (std::size_t k = 0; k < from.size(); ++k) {
            const double there = outline.places(from[k].at);
            const auto image = std::ranges::find_if(to, [&](const TurnPoint& point) {
                return std::abs(std::remainder(point.at - there, turn)) < kSameTurnPoint;
            });
            if (image != to.end()) {
                found.push_back(
                    {lead, static_cast<int>(k), p, static_cast<int>(image - to.begin())});
            }
        }
    }
    return found;
}

void makeTurnsEqual(const std::vector<MirroredPoint>& points,
                    std::vector<OutlineSegments>& segments) {
    const std::vector<OutlineSegments> before = segments;
    for (const auto& [lead, point, piece, image] : points) {
        const double turn =
            0.5 * (before[lead].turnPoints[point].turn + before[piece].turnPoints[image].turn);
        segments[lead].turnPoints[point].turn = turn;
        segments[piece].turnPoints[image].turn = turn;
    }
}

void makeChangesEqual(const std::vector<MirroredPoint>& points,
                      std::vector<std::vector<double>>& changes) {
    const std::vector<std::vector<double>> before = changes;
    for (const auto& [lead, point, piece, image] : points) {
        changes[lead][point] = 0.5 * (before[lead][point] + before[piece][image]);
        changes[piece][image] = changes[lead][point];
    }
}

/// For a piece that is symmetric in itself: adds the mirror images of darts; if both of a pair are
/// set, the first one's intake counts.
std::vector<TypedDart> withImages(const std::vector<TypedDart>& darts, const MirrorPlaces& places) {
    const double turn = places.rising.back() - places.rising.front();
    std::vector<TypedDart> all;
    const auto holds = [&](const TypedDart& dart) -> bool {
        return std::ranges::any_of(all, [&](const TypedDart& one) {
            return std::abs(std::remainder(one.tip - dart.tip, turn)) < kSameTurnPoint;
        });
    };
    for (const TypedDart& dart : darts) {
        TypedDart image = dart;
        const double from = places(dart.to);
        const double before = turn * std::floor(from / turn);
        image.from = from - before;
        image.tip = places(dart.tip) - before;
        image.to = places(dart.from) - before;
        for (const TypedDart& one : {dart, image}) {
            if (!holds(one)) {
                all.push_back(one);
            }
        }
    }
    std::ranges::sort(all, {}, &TypedDart::from);
    return all;
}

Result<FlatLine> reshapedLine(const OutlineReference& reference, const OutlinePlan& plan,
                              const Progress& progress) {
    const auto reshaped = reshapedOutline(reference, plan, progress);
    return reshaped ? Result<FlatLine>(lineOf(*reshaped)) : reshaped.error();
}

/// Largest distance of a line from the outline near which it is drawn.
double strayOf(const FlatLine& line, const OutlineReference& outline) {
    const auto exact = geometry::Line::closed(outline.points, outline.arc);
    double farthest = 0;
    for (Eigen::Index k = 0; k < line.points.rows(); ++k) {
        farthest = std::max(farthest, (line.points.row(k) - exact.pointAt(line.arc[k])).norm());
    }
    return farthest;
}

}  // namespace

double roughness(const PieceResults& results, const std::vector<OutlineSegments>& segments) {
    constexpr double kApart = 20;  // mm: shorter than wrinkles, longer than noise
    constexpr std::size_t kFewest = 40;
    std::vector<double> changes;
    for (std::size_t p = 0; p < segments.size(); ++p) {
        if (segments[p].segments.empty()) {
            continue;  // not flat
        }
        const Piece& piece = *results[p]->piece;
        const auto line = geometry::Line::closed(results[p]->flat->Q(piece.boundary, Eigen::all),
                                                 outlineArc(piece));
        for (const Segment& segment : segments[p].segments) {
            std::vector<double> at{segment.at.start};
            for (int k = 1; k < segment.at.count; ++k) {
                if (const double place = line.placeOf(segment.at.first + k);
                    place > at.back() + kApart) {
                    at.push_back(place);
                }
            }
            double last = 0;
            for (std::size_t k = 1; k + 1 < at.size(); ++k) {
                const double before = at[k] - at[k - 1], after = at[k + 1] - at[k];
                const double bend = chordTurn(line, at[k], before, after) / (before + after);
                if (const double change = bend - std::exchange(last, bend); k > 1) {
                    changes.push_back(2 * kApart * std::abs(change));
                }
            }
        }
    }
    return changes.size() < kFewest ? 0 : medianOf(std::move(changes));
}

std::vector<std::shared_ptr<const OutlinePlan>> planOutlines(const Garment& garment,
                                                             const PieceResults& exact,
                                                             const LineSettings& settings,
                                                             const Symmetry* symmetry) {
    const std::size_t count = exact.size();
    std::vector<MirrorPlan> mirrors(count);
    if (symmetry && settings.mirror != Mirror::None) {
        mirrors = planMirrors(garment, exact, *symmetry, settings.mirror);
    }
    std::vector<OutlineSegments> segments;
    std::vector<std::vector<double>> changes;
    bool isWrinkled = false;
    if (settings.fairing) {
        const PieceResults mirrored = withMirroredOutlines(exact, mirrors);
        segments = findSegments(garment, mirrored, settings);
        isWrinkled = roughness(mirrored, segments) > kWrinkledRoughness;
        const std::vector<MirroredPoint> points = mirroredPoints(mirrors, segments);
        makeTurnsEqual(points, segments);
        changes = truedTurns(segments, findSeamEnds(garment, segments, settings));
        makeChangesEqual(points, changes);
    }
    const std::vector<std::vector<TypedDart>> darts = typedDarts(garment, settings);
    std::vector<std::shared_ptr<const OutlinePlan>> plans(count);
    for (std::size_t p = 0; p < count; ++p) {
        const bool isMirrored = mirrors[p].lead >= 0;
        const std::size_t from = isMirrored ? static_cast<std::size_t>(mirrors[p].lead) : p;
        if (!exact[p] || !exact[p]->flat ||
            !(settings.fairing || isMirrored || !darts[from].empty())) {
            continue;
        }
        OutlinePlan plan = settings.fairing
                               ? planOutline(segments[from], settings, changes[from], isWrinkled)
                               : OutlinePlan{};
        plan.darts = darts[from];
        if (isMirrored) {
            plan.mirrored = std::move(mirrors[p].outline);
        }
        if (plan.mirrored && plan.mirrored->isSymmetric) {
            plan.darts = withImages(plan.darts, plan.mirrored->places);
        }
        plans[p] = std::make_shared<const OutlinePlan>(std::move(plan));
    }
    return plans;
}

Result<FlatLine> drawnOutline(const Piece& piece, const FlatPiece& exact, const OutlinePlan& plan,
                              const Progress& progress) {
    const OutlineReference solved = referenceOf(piece, exact);
    const bool isFair = !plan.stretches.empty();
    if (isFair && !plan.mirrored) {
        return fairOutline(solved, plan, progress);
    }
    const OutlineReference& reference = plan.mirrored ? plan.mirrored->reference : solved;
    auto line =
        isFair ? fairOutline(reference, plan, progress) : reshapedLine(reference, plan, progress);
    if (line && plan.mirrored) {
        line = mirroredFor(*plan.mirrored, std::move(*line));
    }
    if (!line) {
        return line.error();
    }
    layOver(*line, solved);
    line->farthest = isFair ? line->farthest : strayOf(*line, solved);
    return line;
}

}  // namespace toile
