// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/segments.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/pattern/edge_kinds.h"
#include "core/seam/outline.h"
#include "core/seam/seam_settings.h"

namespace toile {

double chordTurn(const geometry::Line& line, double at, double before, double after) {
    const Eigen::RowVector2d here = line.pointAt(at);
    return geometry::turnBetween(here - line.pointAt(at - before), line.pointAt(at + after) - here);
}

std::vector<int> findCorners(const Points2& points, const TurnLimit& limit) {
    const auto line = geometry::Line::closed(points);
    const int n = line.count();
    const double window = std::min(limit.chord, line.length() / 4);
    std::vector<double> own(n), chord(n);
    for (int k = 0; k < n; ++k) {
        own[k] = std::abs(line.turnAt(k));
        chord[k] = std::abs(chordTurn(line, line.arc()[k], window, window));
    }
    std::vector<int> strongest;
    for (int k = 0; k < n; ++k) {
        if (chord[k] > limit.turn) {
            strongest.push_back(k);
        }
    }
    std::ranges::stable_sort(strongest, std::greater<>(), [&own](int k) { return own[k]; });
    std::set<int> corners;
    for (const int k : strongest) {
        // Near a known corner the chords end at it, so that its turn is not counted twice.
        double before = window, after = window;
        if (!corners.empty()) {
            const auto next = corners.lower_bound(k);
            const int behind = next == corners.end() ? *corners.begin() : *next;
            const int ahead = next == corners.begin() ? *corners.rbegin() : *std::prev(next);
            before = std::min(before, line.wrap(line.arc()[k] - line.arc()[ahead]));
            after = std::min(after, line.wrap(line.arc()[behind] - line.arc()[k]));
        }
        const bool isAlone = before == window && after == window;
        const bool isSecond = own[k] > limit.turn && std::min(before, after) > kOneCorner &&
                              std::abs(chordTurn(line, line.arc()[k], before, after)) > limit.turn;
        if (isAlone || isSecond) {
            corners.insert(k);
        }
    }
    return {corners.begin(), corners.end()};
}

namespace {

/// Turn points nearer to each other than this are the same, mm.
constexpr double kSamePoint = 1e-4;
/// Search distance for a corner that was removed, mm.
constexpr double kSameCorner = 5;

/// Divides the outline of a piece into segments.
class Divider {
public:
    Divider(const Garment& garment, int index, const PieceResult& result,
            const seam::Outline& outline, const std::vector<FoundEdge>& edges)
        : garment_(garment),
          piece_(*result.piece),
          index_(index),
          outline_(outline),
          edges_(edges),
          line_(geometry::Line::closed(result.flat->Q(piece_.boundary, Eigen::all),
                                       outline.line.arc().values())),
          corners_(findCorners(line_.points(), kPlainCorner)) {}

    OutlineSegments divided(const LineSettings& settings) {
        addSeamEnds();
        addCorners();
        for (const TurnPointSettings& stated : settings.turnPoints) {
            apply(stated);
        }
        finishTurns();
        OutlineSegments made;
        made.turnPoints = std::move(points_);
        const std::size_t count = std::max<std::size_t>(1, made.turnPoints.size());
        for (std::size_t k = 0; k < count; ++k) {
            made.segments.push_back(segment(made.turnPoints, k, settings));
        }
        return made;
    }

private:
    double perimeter() const { return outline_.length(); }
    double apart(double a, double b) const { return outline_.line.apart(a, b); }

    std::vector<TurnPoint>::iterator near(double at, double within) {
        if (points_.empty()) {
            return points_.end();
        }
        const auto after = std::ranges::lower_bound(points_, outline_.wrap(at), {}, &TurnPoint::at);
        const auto next = after == points_.end() ? points_.begin() : after;
        const auto before = std::prev(after == points_.begin() ? points_.end() : after);
        const auto nearest = apart(next->at, at) < apart(before->at, at) ? next : before;
        return apart(nearest->at, at) <= within ? nearest : points_.end();
    }

    void add(TurnPoint point) {
        point.at = outline_.wrap(point.at);
        const auto known = near(point.at, kSamePoint);
        if (known == points_.end()) {
            points_.insert(std::ranges::lower_bound(points_, point.at, {}, &TurnPoint::at), point);
            return;
        }
        known->isCorner |= point.isCorner;
        known->isSeamEnd |= point.isSeamEnd;
        known->byHand |= point.byHand;
    }

    void addSeamEnds() {
        if (static_cast<std::size_t>(index_) >= garment_.seams.seamsOfEdge.size()) {
            return;  // seams were not searched for
        }
        std::set<int> touching;
        for (const std::vector<int>& ofEdge : garment_.seams.seamsOfEdge[index_]) {
            touching.insert(ofEdge.begin(), ofEdge.end());
        }
        for (const int s : touching) {
            const Seam& seam = garment_.seams.seams[s];
            for (const SeamSide* side : {&seam.left, &seam.right}) {
                if (side->piece != index_ || side->loop != 0) {
                    continue;
                }
                sides_.push_back({s, side == &seam.right, side});
                if (!seam.closed) {
                    add({side->start, 0, false, true});
                    add({side->end, 0, false, true});
                }
            }
        }
    }

    /// Whether a wrinkle has moved the end of a seam to another vertex: a corner of less than 60
    /// degrees, and the end itself turns too little for one.
    bool isMovedEnd(double at) const {
        constexpr double kBlunt = 1.0471975511965976;
        const auto turn = [&](double place, double chord) {
            chord = std::min(chord, perimeter() / 4);
            return std::abs(chordTurn(line_, place, chord, chord));
        };
        return turn(at, kPlainCorner.chord) < kBlunt &&
               std::ranges::any_of(points_, [&](const TurnPoint& end) {
                   return end.isSeamEnd && apart(end.at, at) < kSeamChangeCorner.chord &&
                          turn(end.at, kSeamChangeCorner.chord) < kSeamChangeCorner.turn;
               });
    }

    /// A corner beside the end of a seam is that end, unless the line turns by a corner's angle at
    /// the vertex itself.
    void addCorners() {
        for (const int corner : corners_) {
            const double at = outline_.arcOf(corner);
            if (isMovedEnd(at)) {
                continue;
            }
            const auto beside = near(at, kPlainCorner.chord);
            if (beside == points_.end() || (std::abs(line_.turnAt(corner)) > kPlainCorner.turn &&
                                            apart(beside->at, at) > kOneCorner)) {
                add({at, 0, true});
            }
        }
    }

    void apply(const TurnPointSettings& stated) {
        const double sense = stated.reversed ? -1 : 1;
        const LineStretch place{stated.line, stated.at - sense * 1e-9, stated.at + sense * 1e-9};
        for (const geometry::Interval& part : partsOf(place, outline_, piece_)) {
            const double at = (part.low + part.high) / 2;
            if (stated.turns) {
                add({at, 0, true, false, true});
            } else if (const auto known = near(at, kSameCorner);
                       known != points_.end() && (known->isCorner || known->isSeamEnd)) {
                known->isCorner = false;
                known->byHand = true;
            }
            return;
        }
    }

    /// Measures the turn at each point by chords that pass no other point. Ends of seams are tested
    /// for corners by longer chords, which may pass other points but no sharp corner.
    void finishTurns() {
        std::erase_if(points_, [](const TurnPoint& p) {
            return !p.isCorner && !p.isSeamEnd;  // a corner that was removed
        });
        const std::size_t count = points_.size();
        std::vector<bool> isSharp(count);
        for (std::size_t k = 0; k < count; ++k) {
            isSharp[k] = std::abs(chordTurn(line_, points_[k].at, kOneCorner, kOneCorner)) >
                         kPlainCorner.turn;
        }
        for (std::size_t k = 0; k < count; ++k) {
            const double at = points_[k].at;
            const std::size_t last = (k + count - 1) % count, next = (k + 1) % count;
            const auto chord = [&](double way, bool isEnd, double longest) -> double {
                way = way > 0 ? way : way + perimeter();
                return std::min({isEnd ? way : longest, longest, perimeter() / 4});
            };
            const auto turnOver = [&](double longest, bool endsBefore, bool endsAfter) -> double {
                const double before = chord(at - points_[last].at, endsBefore, longest);
                const double after = chord(points_[next].at - at, endsAfter, longest);
                return nearTurnIn3d(chordTurn(line_, at, before, after), at);
            };
            points_[k].turn = turnOver(kPlainCorner.chord, true, true);
            if (points_[k].isSeamEnd && !points_[k].byHand) {
                const double turn = turnOver(kSeamChangeCorner.chord, isSharp[last], isSharp[next]);
                points_[k].isCorner |= std::abs(turn) > kSeamChangeCorner.turn;
            }
        }
    }

    /// Resolves full turns by the turn of the cloth: at the end of a slit it is half a turn to the
    /// right, at a spike to the left.
    double nearTurnIn3d(double turn, double at) const {
        const int vertex = outline_.edgeAt(at + kSamePoint / 2);
        const bool isVertex = apart(outline_.arcOf(vertex), at) < kSamePoint;
        const double in3d = isVertex ? std::numbers::pi - outline_.angle[vertex] : 0;
        return in3d + std::remainder(turn - in3d, 2 * std::numbers::pi);
    }

    Segment segment(const std::vector<TurnPoint>& points, std::size_t k,
                    const LineSettings& settings) const {
        Segment made;
        made.at.piece = index_;
        made.at.start = points.empty() ? 0 : points[k].at;
        made.at.end = points.empty() ? perimeter() : points[(k + 1) % points.size()].at;
        if (made.at.end <= made.at.start) {
            made.at.end += perimeter();
        }
        made.at.first = outline_.edgeAt(made.at.start + kSamePoint / 2);
        int last = outline_.edgeAt(made.at.end - kSamePoint / 2);
        while (last < made.at.first || outline_.arcOf(last + 1) < made.at.end - kSamePoint) {
            last += outline_.size();
        }
        made.at.count = last - made.at.first + 1;
        const double middle = (made.at.start + made.at.end) / 2;
        for (const auto& [seam, isRight, side] : sides_) {
            const auto [low, high] = std::minmax(side->start, side->end);
            const double past = outline_.wrap(middle - low);
            if (past < high - low && (made.seam < 0 || !garment_.seams.seams[seam].stacked)) {
                made.seam = seam;
                made.isRight = isRight;
            }
        }
        if (made.seam < 0 || garment_.seams.seams[made.seam].kind == SeamKind::Free) {
            setEdge(made);
        }
        made.place = stretchOf(made.at, outline_, piece_);
        made.settings = statedOf(made.place, settings.segments);
        return made;
    }

    /// Sets the kind that most of a free segment has.
    void setEdge(Segment& made) const {
        std::map<std::pair<EdgeKind, int>, double> lengths;
        for (int k = made.at.first; k < made.at.first + made.at.count; ++k) {
            const FoundEdge& edge = edges_[outline_.wrapIndex(k)];
            lengths[{edge.kind, edge.opening}] += outline_.arcOf(k + 1) - outline_.arcOf(k);
        }
        const auto most =
            std::ranges::max_element(lengths, {}, [](const auto& of) { return of.second; });
        std::tie(made.foundEdge, made.opening) = most->first;
    }

    /// The best fit among settings that cover more than half of a segment; of equals the last.
    static SegmentSettings statedOf(const LineStretch& place,
                                    const std::vector<SegmentSettings>& settings) {
        SegmentSettings found;
        double best = 0;
        for (const SegmentSettings& stated : settings) {
            const double has = covered(place, stated.place);
            const double fits = has > 0.5 ? has * covered(stated.place, place) : 0;
            if (fits > 0 && fits >= best) {
                best = fits;
                found = stated;
            }
        }
        found.place = place;
        return found;
    }

    struct SideHere {
        int seam;
        bool isRight;
        const SeamSide* side;
    };

    const Garment& garment_;
    const Piece& piece_;
    int index_;
    const seam::Outline& outline_;
    const std::vector<FoundEdge>& edges_;  ///< of the outline
    geometry::Line line_;
    std::vector<int> corners_;
    std::vector<SideHere> sides_;
    std::vector<TurnPoint> points_;  ///< by `at`
};

}  // namespace

PieceResults exactResults(const Garment& garment, const PieceResults& results) {
    PieceResults exact(garment.pieces.size());
    for (std::size_t p = 0; p < exact.size() && p < results.size(); ++p) {
        const auto& result = results[p];
        if (result && result->piece == garment.pieces[p] && result->flat) {
            exact[p] = result->exact ? result->exact : result;
        }
    }
    return exact;
}

std::vector<OutlineSegments> findSegments(const Garment& garment, const PieceResults& results,
                                          const LineSettings& settings) {
    const seam::Outlines outlines = seam::buildOutlines(garment.pieces);
    const auto edges = findEdgeKinds(garment, outlines);
    std::vector<OutlineSegments> made(garment.pieces.size());
    for (std::size_t p = 0; p < made.size(); ++p) {
        if (p < results.size() && results[p] && results[p]->flat) {
            made[p] = Divider(garment, static_cast<int>(p), *results[p], outlines.list[p], edges[p])
                          .divided(settings);
        }
    }
    return made;
}

}  // namespace toile
