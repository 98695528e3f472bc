// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/dart_places.h"

#include <algorithm>
#include <cmath>

#include "core/cut/surface_paths.h"
#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/pattern/outline_reference.h"
#include "core/seam/seam_settings.h"

namespace toile {
namespace {

constexpr double kCutAtTip = 0.01;  // mm: a cut starts there
constexpr double kAhead = 1e-6;     // mm: excludes edges at the tip itself

/// First intersection of a ray with a closed line.
struct RayHit {
    double way = 0;  ///< mm; 0: none
    int edge = -1;
    double share = 0;
};

RayHit firstHit(const Eigen::RowVector2d& from, const Eigen::RowVector2d& along,
                const Points2& line) {
    RayHit first;
    for (Eigen::Index k = 0; k < line.rows(); ++k) {
        const Eigen::RowVector2d a = line.row(k);
        const Eigen::RowVector2d edge = line.row((k + 1) % line.rows()) - a;
        const double across = geometry::cross(along, edge);
        if (across == 0) {
            continue;
        }
        const double way = geometry::cross(a - from, edge) / across;
        const double share = geometry::cross(a - from, along) / across;
        if (way > kAhead && share >= 0 && share <= 1 && (first.edge < 0 || way < first.way)) {
            first = {way, static_cast<int>(k), share};
        }
    }
    return first;
}

bool isOnRim(const SurfaceLinks& links, const SurfacePoint& point) {
    const Carrier on = links.carrierOf(point);
    return on.kind == Carrier::Kind::Vertex
               ? !links.isInner(on.index)
               : links.facesOf(on).size() == 1 && on.kind == Carrier::Kind::Edge;
}

/// The ends of a cut inside the piece that it is made in.
std::vector<Eigen::Vector3d> tipsOf(const SurfaceLinks& links, const NearestSurface& nearest,
                                    const UserCut& cut) {
    std::vector<Eigen::Vector3d> tips;
    const auto points = pointsOfCut(links, nearest, cut);
    if (points && cut.kind != UserCut::Kind::Loop) {
        for (const SurfacePoint& end : {points->front(), points->back()}) {
            if (!isOnRim(links, end)) {
                tips.push_back(positionOf(links.mesh(), end));
            }
        }
    }
    return tips;
}

/// The path among a piece's cuts that starts at a tip of one of these darts.
std::optional<CutId> cutFromTip(const CutRecord& record, const std::vector<CutId>& darts) {
    const SurfaceLinks links(record.whole->mesh, record.whole->table);
    const NearestSurface nearest(record.whole->mesh);
    for (const UserCut& dart : record.requested) {
        if (std::ranges::find(darts, dart.id) == darts.end()) {
            continue;
        }
        for (const Eigen::Vector3d& tip : tipsOf(links, nearest, dart)) {
            // If two start there, the later one continues the dart.
            const auto found = std::ranges::find_if(
                record.requested.rbegin(), record.requested.rend(), [&](const UserCut& cut) {
                    return cut.kind == UserCut::Kind::Path && cut.id != dart.id &&
                           !cut.points.empty() && (cut.points.front() - tip).norm() < kCutAtTip;
                });
            if (found != record.requested.rend()) {
                return found->id;
            }
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<UserCut> cutBeyondDart(const Garment& garment, const PieceResults& results,
                                     int seam) {
    const auto dart = dartPlace(garment, seam);
    const auto p = static_cast<std::size_t>(dart ? dart->piece : 0);
    if (!dart || p >= results.size() || !results[p] || !results[p]->flat ||
        results[p]->piece != garment.pieces[p]) {
        return std::nullopt;
    }
    const Piece& piece = *garment.pieces[p];
    const auto outline =
        geometry::Line::closed(results[p]->flat->Q(piece.boundary, Eigen::all), outlineArc(piece));
    const Eigen::RowVector2d tip = outline.pointAt(dart->tip);
    const Eigen::RowVector2d mouth =
        0.5 * (outline.pointAt(dart->from) + outline.pointAt(dart->to));
    const Eigen::RowVector2d along = (tip - mouth).normalized();
    const RayHit hit = firstHit(tip, along, outline.points());
    if (hit.edge < 0) {
        return std::nullopt;
    }
    for (const auto& hole : piece.holes) {
        const RayHit rim = firstHit(tip, along, results[p]->flat->Q(hole, Eigen::all));
        if (rim.edge >= 0 && rim.way < hit.way) {
            return std::nullopt;
        }
    }
    const auto placeOf = [&](int edge, double share) -> Eigen::Vector3d {
        const auto k = static_cast<std::size_t>(edge);
        return (1 - share) * piece.mesh.V.row(piece.boundary[k]) +
               share * piece.mesh.V.row(piece.boundary[(k + 1) % piece.boundary.size()]);
    };
    const int atTip = outline.edgeAt(dart->tip + kAhead / 2);
    const double past = outline.wrap(dart->tip) - outline.arc()[static_cast<std::size_t>(atTip)];
    const double length = outline.arc()[static_cast<std::size_t>(atTip) + 1] -
                          outline.arc()[static_cast<std::size_t>(atTip)];
    UserCut cut;
    cut.points = {placeOf(atTip, std::clamp(past / length, 0.0, 1.0)),
                  placeOf(hit.edge, hit.share)};
    return cut;
}

std::optional<CutId> cutBeyondTip(const Garment& garment, int index) {
    const Seam& seam = garment.seams.seams[static_cast<std::size_t>(index)];
    for (const CutRecord& record : garment.cutRecords) {
        const bool isHere = record.requested.size() > 1 &&
                            std::ranges::any_of(record.requested, [&seam](const UserCut& cut) {
                                return std::ranges::find(seam.cuts, cut.id) != seam.cuts.end();
                            });
        if (const auto found = isHere ? cutFromTip(record, seam.cuts) : std::nullopt) {
            return found;
        }
    }
    return std::nullopt;
}

namespace {

constexpr double kOneTip = 0.01;  // mm: between the end of one side and the start of the other
constexpr double kInDart = 1e-6;  // mm

double inFirstTurn(double at, double perimeter) {
    return at - perimeter * std::floor(at / perimeter);
}

}  // namespace

std::optional<DartPlace> dartPlace(const Garment& garment, int seam) {
    const Seam& dart = garment.seams.seams[static_cast<std::size_t>(seam)];
    if (dart.kind != SeamKind::Dart || dart.left.piece < 0 || dart.left.piece != dart.right.piece ||
        dart.left.loop != 0 || dart.right.loop != 0) {
        return std::nullopt;
    }
    const Piece& piece = *garment.pieces[static_cast<std::size_t>(dart.left.piece)];
    const double perimeter = outlineArc(piece).back();
    const auto place = [&](const SeamSide& first,
                           const SeamSide& second) -> std::optional<DartPlace> {
        const double tip = std::max(first.start, first.end);
        const double next = std::min(second.start, second.end);
        if (!(std::abs(std::remainder(tip - next, perimeter)) < kOneTip) ||
            !(first.length() > kOneTip) || !(second.length() > kOneTip) ||
            !(perimeter - first.length() - second.length() > kOneTip)) {
            return std::nullopt;
        }
        const double from = inFirstTurn(tip - first.length(), perimeter);
        return DartPlace{dart.left.piece, from, from + first.length(),
                         from + first.length() + second.length()};
    };
    const auto found = place(dart.left, dart.right);
    return found ? found : place(dart.right, dart.left);
}

double intakeOf(const DartPlace& dart, double angle) {
    const double a = dart.firstLeg(), b = dart.secondLeg(), half = std::sin(angle / 2);
    return std::sqrt((a - b) * (a - b) + 4 * a * b * half * half);
}

double angleOf(const DartPlace& dart, double intake) {
    const double a = dart.firstLeg(), b = dart.secondLeg();
    const double square = (intake - (a - b)) * (intake + (a - b)) / (4 * a * b);
    return 2 * std::asin(std::sqrt(std::clamp(square, 0.0, 1.0)));
}

std::map<int, DartSettings> statedDarts(const SeamGraph& graph, const LineSettings& settings) {
    std::map<int, DartSettings> stated;
    for (const DartSettings& one : settings.darts) {
        const int seam = seamAt(graph, one.seam);
        if (seam >= 0 && graph.seams[static_cast<std::size_t>(seam)].kind == SeamKind::Dart) {
            stated[seam] = one;
        }
    }
    return stated;
}

std::vector<std::vector<TypedDart>> typedDarts(const Garment& garment,
                                               const LineSettings& settings) {
    std::vector<std::vector<TypedDart>> typed(garment.pieces.size());
    for (const auto& [seam, stated] : statedDarts(garment.seams, settings)) {
        const auto place = stated.intake ? dartPlace(garment, seam) : std::nullopt;
        if (place) {
            typed[static_cast<std::size_t>(place->piece)].push_back({*place, *stated.intake});
        }
    }
    for (std::size_t p = 0; p < typed.size(); ++p) {
        std::ranges::sort(typed[p], {}, &TypedDart::from);
        std::vector<TypedDart> kept;
        for (const TypedDart& dart : typed[p]) {
            const double perimeter = outlineArc(*garment.pieces[p]).back();
            const bool isApart = std::ranges::none_of(kept, [&](const TypedDart& other) {
                return isWithin(other, perimeter, dart.tip) || isWithin(dart, perimeter, other.tip);
            });
            if (isApart) {
                kept.push_back(dart);
            }
        }
        typed[p] = std::move(kept);
    }
    return typed;
}

bool isWithin(const DartPlace& dart, double perimeter, double at) {
    const double past = inFirstTurn(at - dart.from, perimeter);
    return past > kInDart && past < dart.to - dart.from - kInDart;
}

}  // namespace toile
