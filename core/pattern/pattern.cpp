// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/pattern.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "core/base/text.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/pattern/dart_places.h"
#include "core/pattern/drawn_outline.h"
#include "core/pattern/extension.h"
#include "core/pattern/facings.h"
#include "core/pattern/half_pattern.h"
#include "core/pattern/internal_lines.h"
#include "core/pattern/notches.h"
#include "core/pattern/outline_reference.h"
#include "core/pattern/piece_allowance.h"
#include "core/pattern/segments.h"
#include "core/seam/seam_measure.h"

namespace toile {

namespace {

/// The outline of a piece as drawn, measured in 3D and in the plane.
struct MeasuredOutline {
    geometry::Line in3d, flat;

    MeasuredOutline(const Piece& piece, const FlatPiece& of)
        : in3d(of.line
                   ? geometry::Line::closed(of.line->points, of.line->arc)
                   : geometry::Line::closed(of.Q(piece.boundary, Eigen::all), outlineArc(piece))),
          flat(geometry::Line::closed(in3d.points())) {}

    /// In the plane; the first is within the first turn.
    std::pair<double, double> places(double from3d, double to3d) const {
        const double from = in3d.placeOn(flat, from3d), to = in3d.placeOn(flat, to3d);
        const double first = flat.wrap(from);
        return {first, first + to - from};
    }
};

void addSide(PatternPiece& made, const Piece& piece, const FlatPiece& flat,
             const MeasuredOutline& outline, const Seam& seam, int number, const SeamSide& side) {
    Points2 line = flatLine(side, piece, flat);
    if (side.reversed) {
        line = line.colwise().reverse().eval();
    }
    SeamLine& added = made.seams.emplace_back(SeamLine{
        number, seam.name, std::move(line), seam.closed, seam.kind, &side == &seam.right, seam.id});
    added.length3d = side.length();
    if (side.loop == 0) {
        const auto [low, high] = std::minmax(side.start, side.end);
        std::tie(added.from, added.to) = outline.places(low, high);
    }
}

void addSeams(PatternPiece& made, const Piece& piece, const FlatPiece& flat,
              const MeasuredOutline& outline, const SeamGraph& graph, int index) {
    std::set<int> touched;
    if (index < static_cast<int>(graph.seamsOfEdge.size())) {
        for (const std::vector<int>& ofEdge : graph.seamsOfEdge[index]) {
            touched.insert(ofEdge.begin(), ofEdge.end());
        }
    }
    if (index < static_cast<int>(graph.seamsOfHoles.size())) {
        touched.insert(graph.seamsOfHoles[index].begin(), graph.seamsOfHoles[index].end());
    }
    for (const int k : touched) {
        const Seam& seam = graph.seams[k];
        for (const SeamSide* side : {&seam.left, &seam.right}) {
            if (side->piece == index) {
                addSide(made, piece, flat, outline, seam, k + 1, *side);
            }
        }
    }
}

void addSegments(PatternPiece& made, const PieceResult& result, const MeasuredOutline& outline,
                 const SeamGraph& graph, const OutlineSegments& found, const LineSettings& lines) {
    const Piece& piece = *result.piece;
    const auto in3d =
        geometry::Line::closed(result.flat->Q(piece.boundary, Eigen::all), outlineArc(piece));
    const auto target = geometry::Line::closed(
        in3d.points(), geometry::arcOf(outlineLengths(piece, result.targets)));
    for (std::size_t k = 0; k < found.segments.size(); ++k) {
        const Segment& segment = found.segments[k];
        PatternSegment& added = made.segments.emplace_back();
        std::tie(added.from, added.to) = outline.places(segment.at.start, segment.at.end);
        added.isCorner = k < found.turnPoints.size() && keepsTurn(found.turnPoints[k]);
        added.seam = segment.seam + 1;
        added.isRight = segment.isRight;
        added.kind = segment.seam < 0 ? SeamKind::Free : graph.seams[segment.seam].kind;
        added.place = segment.place;
        added.length =
            in3d.placeOn(target, segment.at.end) - in3d.placeOn(target, segment.at.start);
        added.isFaced = std::ranges::any_of(
            lines.facings, [&added](const Facing& facing) { return isFaced(added.place, facing); });
        added.edge = segment.edge();
        added.foundEdge = segment.foundEdge;
        added.opening = segment.opening;
        if (lines.allowance) {
            added.usualAllowance = usualAllowance(added, *lines.allowance);
            added.isAllowanceSet = segment.settings.allowance || lines.allowance->of(added.edge);
            added.allowance = segment.settings.allowance.value_or(added.usualAllowance);
        }
        added.corner = segment.settings.corner;
        added.extension = segment.settings.extension.value_or(0);
    }
    std::ranges::stable_sort(made.segments, {}, &PatternSegment::from);
}

/// Adds every notch to both sides of its seam, if it is shown there.
void addNotches(Pattern& pattern, const SeamGraph& graph,
                const std::vector<std::vector<Notch>>& notches) {
    for (const std::vector<Notch>& ofSeam : notches) {
        for (const Notch& notch : ofSeam) {
            const Seam& seam = graph.seams[notch.seam];
            PieceNotch there{.seam = notch.seam + 1,
                             .share = notch.share,
                             .count = notch.count,
                             .reason = notch.reason};
            for (const bool isRight : {false, true}) {
                const SeamSide& side = isRight ? seam.right : seam.left;
                if (isRight ? notch.onRight : notch.onLeft) {
                    there.hole = side.loop - 1;
                    there.at = isRight ? notch.flat.right : notch.flat.left;
                    pattern.pieces[side.piece].notches.push_back(there);
                }
            }
        }
    }
    for (PatternPiece& piece : pattern.pieces) {
        std::ranges::stable_sort(piece.notches, {}, [](const PieceNotch& notch) {
            return std::pair(notch.hole, notch.at);
        });
    }
}

/// Adds internal lines as they lie flat, without points on straight stretches.
void addInternals(Pattern& pattern, const Garment& garment, const PieceResults& results,
                  const std::vector<InternalLine>& lines) {
    constexpr double kMaxBend = 1e-5;  // mm
    for (InternalRun& run : findInternalRuns(garment, results, lines)) {
        const auto i = static_cast<std::size_t>(run.piece);
        PieceInternal added{.line = run.line,
                            .name = lines[static_cast<std::size_t>(run.line)].name,
                            .closed = run.closed,
                            .way = std::move(run.way)};
        if (i < results.size() && results[i] && results[i]->flat &&
            results[i]->piece == garment.pieces[i]) {
            std::vector<Eigen::RowVector2d> points;
            for (const SurfacePoint& point : added.way) {
                const Eigen::RowVector2d next =
                    flatPositionOf(results[i]->flat->Q, results[i]->piece->mesh.F, point);
                added.length += points.empty() ? 0 : (next - points.back()).norm();
                const std::size_t n = points.size();
                if (n > 1 &&
                    geometry::distanceToSegment(points[n - 1], points[n - 2], next) < kMaxBend) {
                    points.pop_back();
                }
                points.push_back(next);
            }
            if (added.closed) {
                points.pop_back();
            }
            added.points.resize(static_cast<Eigen::Index>(points.size()), 2);
            for (std::size_t k = 0; k < points.size(); ++k) {
                added.points.row(static_cast<Eigen::Index>(k)) = points[k];
            }
        }
        pattern.pieces[i].internals.push_back(std::move(added));
    }
}

}  // namespace

Pattern makePattern(const Garment& garment, const PieceResults& results, const LineSettings& lines,
                    std::shared_ptr<const Symmetry> symmetry) {
    Pattern pattern;
    pattern.name =
        garment.files.empty() ? std::string() : garment.files.front()->path.stem().string();
    pattern.pieces.resize(garment.pieces.size());
    pattern.exactSegments = findSegments(garment, exactResults(garment, results), lines);
    const std::vector<DrawnMirror> mirrors = drawnMirrors(results);
    const std::map<int, DartSettings> darts = statedDarts(garment.seams, lines);
    UniqueNames slugs;
    int number = 0;
    for (std::size_t i = 0; i < garment.pieces.size(); ++i) {
        PatternPiece& made = pattern.pieces[i];
        made.name = garment.pieces[i]->name;
        made.id = garment.pieces[i]->id;
        if (i >= results.size() || !results[i] || !results[i]->flat) {
            continue;
        }
        const Piece& piece = *results[i]->piece;
        const FlatPiece& flat = *results[i]->flat;
        made.number = ++number;
        made.slug = slugs.free(slug(made.name), "-");
        made.holes = flatLoops(piece, flat);
        made.outline = std::move(made.holes.front());
        made.holes.erase(made.holes.begin());
        made.isFine = flat.line && results[i]->plan && !results[i]->plan->stretches.empty();
        made.mirror = mirrors[i];
        const MeasuredOutline outline(piece, flat);
        addSeams(made, piece, flat, outline, garment.seams, static_cast<int>(i));
        addSegments(made, *results[i], outline, garment.seams, pattern.exactSegments[i], lines);
        for (const SeamLine& seam : made.seams) {
            if (const auto stated = darts.find(seam.number - 1); stated != darts.end()) {
                made.statedDarts.emplace(seam.seam, stated->second);
            }
        }
    }
    limitAllowances(pattern.pieces);
    for (PatternPiece& made : pattern.pieces) {
        const bool isExtended = std::ranges::any_of(
            made.segments, [](const auto& segment) { return extensionOf(segment) > 0; });
        if (made.outline.rows() > 0 && (lines.allowance || isExtended)) {
            addCuttingLine(made);
        }
    }
    dropUnequalMirrors(pattern.pieces);
    pattern.label = lines.label;
    pattern.hasAllowance = lines.allowance.has_value();
    pattern.hasNotches = lines.notches.has_value();
    if (lines.notches) {
        addNotches(
            pattern, garment.seams,
            findNotches(garment, results, pattern.exactSegments, *lines.notches, symmetry.get()));
        pattern.notchForm = lines.notches->form;
        pattern.notchDepth = lines.notches->depth;
    }
    pattern.facings = facingsOf(pattern, lines.facings);
    for (FacingPiece& facing : pattern.facings) {
        facing.strip.slug = slugs.free(slug(facing.strip.name), "-");
    }
    addInternals(pattern, garment, results, lines.internalLines);
    pattern.symmetry = std::move(symmetry);
    return pattern;
}

std::vector<Points2> flatLoops(const Piece& piece, const FlatPiece& flat) {
    std::vector<Points2> loops{flat.line ? flat.line->points
                                         : Points2(flat.Q(piece.boundary, Eigen::all))};
    for (const auto& hole : piece.holes) {
        loops.emplace_back(flat.Q(hole, Eigen::all));
    }
    return loops;
}

std::vector<Fabric> fabricsOf(const Pattern& pattern, const Fabric& own) {
    std::vector<Fabric> fabrics;
    fabrics.reserve(pattern.pieces.size());
    for (const PatternPiece& piece : pattern.pieces) {
        fabrics.push_back(fabricOf(piece.material, pattern.materials, own));
    }
    return fabrics;
}

}  // namespace toile
