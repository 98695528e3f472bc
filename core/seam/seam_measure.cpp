// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/seam_measure.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/wording.h"
#include "core/geometry/line.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// A place closer to a vertex than this fraction of the edge is the vertex.
constexpr double kAtVertex = 1e-9;
/// Points of a stretch closer than this are merged, mm.
constexpr double kSamePlace = 1e-6;
constexpr Word<SeamKind> kKinds[] = {{SeamKind::Seam, "seam"},
                                     {SeamKind::Dart, "dart"},
                                     {SeamKind::Fold, "fold"},
                                     {SeamKind::Free, "free"}};

constexpr Word<LengthCause> kCauses[] = {{LengthCause::Mirroring, "mirroring"},
                                         {LengthCause::Length, "length"},
                                         {LengthCause::Ease, "ease"},
                                         {LengthCause::Improving, "improving"}};

/// Methods with a free outline ignore target lengths.
std::vector<ChangedPart> changedParts(const PieceResult& result) {
    return traits(result.options.method).keepsLengths ? result.targets.changed
                                                      : std::vector<ChangedPart>();
}

void keepLargest(std::vector<LengthChange>& changes, const LengthChange& change) {
    const auto same = std::ranges::find(changes, change.cause, &LengthChange::cause);
    if (std::abs(change.millimetres) < kMinLengthChange) {
        return;
    }
    if (same == changes.end()) {
        changes.push_back(change);
    } else if (std::abs(change.millimetres) > std::abs(same->millimetres)) {
        *same = change;
    }
}

/// One edge of a stretch of outline and the part of it that belongs to the stretch.
struct PartOfEdge {
    int tail, head;   ///< vertices
    double from, to;  ///< fractions of the edge; exactly 0 and 1 if the whole edge is included
};

/// The parts of a stretch in outline order, whatever the side's direction.
std::vector<PartOfEdge> partsOf(const SeamSide& side, const Piece& piece) {
    const std::vector<int>& loop = loopOf(side, piece);
    const int n = static_cast<int>(loop.size());
    const auto lengthOf = [&](int k) {
        return (piece.mesh.V.row(loop[(k + 1) % n]) - piece.mesh.V.row(loop[k % n])).norm();
    };
    const auto [low, high] = std::minmax(side.start, side.end);
    // The arc length at which edge `first` begins, summed up as when the seam was found.
    double arc = 0;
    for (int k = 0; k < side.first; ++k) {
        arc += lengthOf(k);
    }
    std::vector<PartOfEdge> parts;
    for (int k = side.first; k < side.first + side.count; ++k) {
        const double length = lengthOf(k);
        // An end at a vertex is set to it exactly, free of rounding in the sums.
        const auto fraction = [&](double place) {
            const double t = std::clamp((place - arc) / length, 0.0, 1.0);
            return t < kAtVertex ? 0 : t > 1 - kAtVertex ? 1 : t;
        };
        parts.push_back({loop[k % n], loop[(k + 1) % n], length > 0 ? fraction(low) : 0,
                         length > 0 ? fraction(high) : 1});
        arc += length;
    }
    return parts;
}

/// The stretch as a polyline through points given per vertex, in the plane or in space.
template <class Points>
Points lineThrough(const SeamSide& side, const Piece& piece, const Points& at) {
    const std::vector<PartOfEdge> parts = partsOf(side, piece);
    if (parts.empty()) {
        return {};
    }
    const auto between = [&at](const PartOfEdge& part, double t) {
        return ((1 - t) * at.row(part.tail) + t * at.row(part.head)).eval();
    };
    Points line(static_cast<Eigen::Index>(parts.size()) + 1, at.cols());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        line.row(static_cast<Eigen::Index>(i)) = between(parts[i], parts[i].from);
    }
    line.template bottomRows<1>() = between(parts.back(), parts.back().to);
    return side.reversed ? Points(line.colwise().reverse()) : line;
}

/// True if the stretch lies on an outline that is not the polygon of its vertices.
bool isDrawn(const SeamSide& side, const FlatPiece& flat) {
    return flat.line && side.loop == 0;
}

}  // namespace

double placeAcross(const Seam& seam, double place, bool fromRight) {
    const auto here = [fromRight](const SeamMatch& m) { return fromRight ? m.right : m.left; };
    const auto there = [fromRight](const SeamMatch& m) { return fromRight ? m.left : m.right; };
    for (std::size_t k = 0; k + 1 < seam.matches.size(); ++k) {
        const SeamMatch &a = seam.matches[k], &b = seam.matches[k + 1];
        const auto [low, high] = std::minmax({here(a), here(b)});
        if (low <= place && place <= high && low < high) {
            const double t = (place - here(a)) / (here(b) - here(a));
            return (1 - t) * there(a) + t * there(b);
        }
    }
    const SeamMatch &first = seam.matches.front(), &last = seam.matches.back();
    const bool isFirst = std::abs(place - here(first)) < std::abs(place - here(last));
    return there(isFirst ? first : last);
}

std::vector<LengthChange> changesOf(const PieceResult& result) {
    std::map<int, LengthChange> sums;  // by change
    for (const ChangedPart& part : changedParts(result)) {
        LengthChange& sum = sums[part.change];
        sum = {part.cause, sum.millimetres + (part.factor - 1) * (part.to - part.from)};
    }
    std::vector<LengthChange> changes;
    for (const auto& [number, sum] : sums) {
        keepLargest(changes, sum);
    }
    return changes;
}

std::vector<LengthChange> changesOf(const Seam& seam, const PieceResults& results) {
    std::vector<LengthChange> changes;
    for (const SeamSide* side : {&seam.left, &seam.right}) {
        const auto at = static_cast<std::size_t>(side->piece);
        if (at >= results.size() || !results[at] || side->loop != 0) {
            continue;
        }
        const double perimeter = outlineLengths(*results[at]->piece, {}).sum();
        const auto [low, high] = std::minmax(side->start, side->end);
        std::map<LengthCause, double> sums;
        for (const ChangedPart& part : changedParts(*results[at])) {
            for (const auto& shared :
                 geometry::commonParts({low, high}, {part.from, part.to}, perimeter)) {
                sums[part.cause] += (part.factor - 1) * shared.length();
            }
        }
        for (const auto& [cause, millimetres] : sums) {
            keepLargest(changes, {cause, millimetres});
        }
    }
    return changes;
}

std::string_view name(LengthCause cause) {
    return wordOf(kCauses, cause);
}

const std::vector<int>& loopOf(const SeamSide& side, const Piece& piece) {
    return side.loop == 0 ? piece.boundary : piece.holes[static_cast<std::size_t>(side.loop) - 1];
}

double flatLength(const SeamSide& side, const Piece& piece, const FlatPiece& flat) {
    if (isDrawn(side, flat)) {
        const auto [low, high] = std::minmax(side.start, side.end);
        return geometry::Line::closed(flat.line->points, flat.line->arc).lengthOf(low, high);
    }
    double length = 0;
    for (const PartOfEdge& part : partsOf(side, piece)) {
        length += (part.to - part.from) * (flat.Q.row(part.head) - flat.Q.row(part.tail)).norm();
    }
    return length;
}

Points2 flatLine(const SeamSide& side, const Piece& piece, const FlatPiece& flat) {
    if (isDrawn(side, flat)) {
        const auto [low, high] = std::minmax(side.start, side.end);
        const Points2 line =
            geometry::Line::closed(flat.line->points, flat.line->arc).part(low, high);
        return side.reversed ? Points2(line.colwise().reverse()) : line;
    }
    return lineThrough(side, piece, flat.Q);
}

Points3 spaceLine(const SeamSide& side, const Piece& piece) {
    return lineThrough(side, piece, piece.mesh.V);
}

StretchLines stretchLines(const SeamSide& side, const Piece& piece, const FlatPiece& flat) {
    if (!isDrawn(side, flat)) {
        return {spaceLine(side, piece), flatLine(side, piece, flat)};
    }
    // Arc lengths of all points of the stretch: ends, vertices and points of the drawn line.
    const auto [low, high] = std::minmax(side.start, side.end);
    const auto space = geometry::SpaceLine::closed(piece.mesh.V(piece.boundary, Eigen::all));
    const auto line = geometry::Line::closed(flat.line->points, flat.line->arc);
    std::vector<double> places{low, high};
    for (const geometry::Arc* arc : {&space.arc(), &line.arc()}) {
        const int end = arc->firstAfter(high - kSamePlace);
        for (int k = arc->firstAfter(low + kSamePlace); k < end; ++k) {
            places.push_back(arc->placeOf(k));
        }
    }
    std::ranges::sort(places);
    const auto same = [](double a, double b) { return b - a < kSamePlace; };
    places.erase(std::unique(places.begin(), places.end(), same), places.end());
    const auto count = static_cast<Eigen::Index>(places.size());
    StretchLines lines{Points3(count, 3), Points2(count, 2)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const double place = side.reversed ? places[count - 1 - i] : places[i];
        lines.space.row(i) = space.pointAt(place);
        lines.flat.row(i) = line.pointAt(place);
    }
    return lines;
}

SeamSide wholeOutline(const Piece& piece, int index) {
    SeamSide whole;
    whole.piece = index;
    whole.count = static_cast<int>(piece.boundary.size());
    whole.end = boundaryLengths3d(piece.mesh.V, piece.boundary).sum();
    return whole;
}

double easeOf(const Seam& seam) {
    if (seam.right.piece < 0 || !(seam.length3d[1] > 0)) {
        return 0;
    }
    return seam.ease.value_or(seam.length3d[0] / seam.length3d[1] - 1);
}

std::string_view name(SeamKind kind) {
    return wordOf(kKinds, kind);
}

SeamMeasure measureSeam(const Seam& seam, const Piece& l, const FlatPiece& flatL, const Piece& r,
                        const FlatPiece& flatR) {
    SeamMeasure measure;
    measure.length3d[0] = seam.length3d[0];
    measure.length3d[1] = seam.length3d[1];
    measure.length2dLeft = flatLength(seam.left, l, flatL);
    if (seam.right.piece < 0) {
        return measure;
    }
    measure.length2dRight = flatLength(seam.right, r, flatR);
    measure.deltaMm = measure.length2dLeft - measure.length2dRight;
    measure.ease = easeOf(seam);
    measure.errorMm = measure.length2dLeft - (1 + measure.ease) * measure.length2dRight;
    return measure;
}

std::optional<SeamMeasure> measured(const Garment& garment, const PieceResults& results, int seam) {
    const Seam& requested = garment.seams.seams[static_cast<std::size_t>(seam)];
    const auto result = [&results](const SeamSide& side) -> const PieceResult* {
        const auto at = static_cast<std::size_t>(side.piece);
        return at < results.size() ? results[at].get() : nullptr;
    };
    const PieceResult* left = result(requested.left);
    const PieceResult* right = requested.right.piece < 0 ? left : result(requested.right);
    if (!left || !right || !left->flat || !right->flat) {
        return std::nullopt;
    }
    return measureSeam(requested, *left->piece, *left->flat, *right->piece, *right->flat);
}

SeamFit seamFit(const Seam& seam, const std::optional<SeamMeasure>& measure) {
    if (!measure || seam.kind == SeamKind::Free) {
        return SeamFit::Unknown;
    }
    const double error = std::abs(measure->errorMm);
    return error <= kMatchesMm  ? SeamFit::Matches
           : error <= kNearlyMm ? SeamFit::Nearly
                                : SeamFit::Differs;
}

}  // namespace toile
