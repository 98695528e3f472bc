// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/drawing/key_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <queue>
#include <utility>

#include "core/geometry/segment.h"
#include "core/pattern/segments.h"

namespace toile {
namespace {

/// Places nearer to each other than this coincide, mm.
constexpr double kSamePlace = 1e-6;

/// The error of a chord between two stations, mm.
struct ChordCost {
    double lost = 0;                ///< length
    double far = 0;                 ///< largest distance of a vertex from the chord
    std::optional<double> split{};  ///< place of the vertex nearest to the middle
};

ChordCost chordCost(const geometry::Line& line, double from, double to) {
    const Eigen::RowVector2d a = line.pointAt(from), b = line.pointAt(to);
    ChordCost cost;
    cost.lost = std::max(0.0, (to - from) - (b - a).norm());
    const double middle = 0.5 * (from + to);
    const int end = line.firstAfter(to - kSamePlace);
    for (int k = line.firstAfter(from + kSamePlace); k < end; ++k) {
        const double at = line.placeOf(k);
        const Eigen::RowVector2d point = line.point(k);
        cost.far =
            std::max(cost.far, (a + geometry::nearestShare(point, a, b) * (b - a) - point).norm());
        if (!cost.split || std::abs(at - middle) < std::abs(*cost.split - middle)) {
            cost.split = at;
        }
    }
    return cost.split ? cost : ChordCost{};
}

/// The part between two neighbouring stations, on both sides.
struct Part {
    double from = 0, to = 1;  ///< shares
    ChordCost costs[2] = {};

    double lost() const { return std::max(costs[0].lost, costs[1].lost); }
    double far() const { return std::max(costs[0].far, costs[1].far); }
    bool operator<(const Part& other) const {
        // Parts too far from their line come first.
        const bool isFar = far() > kKeyFar, otherIsFar = other.far() > kKeyFar;
        return isFar != otherIsFar      ? otherIsFar
               : lost() != other.lost() ? lost() < other.lost()
                                        : from < other.from;
    }
};

class Stations {
public:
    explicit Stations(std::span<const KeyStretch> sides) : sides_(sides) {}

    void add(double from, double to) {
        const Part part = measured(from, to);
        for (std::size_t s = 0; s < sides_.size(); ++s) {
            lost_[s] += part.costs[s].lost;
        }
        parts_.push(part);
    }

    /// Halves parts until both sides are within the tolerances.
    void refine() {
        while (!parts_.empty() &&
               (std::max(lost_[0], lost_[1]) > kKeyLost || parts_.top().far() > kKeyFar)) {
            const Part part = parts_.top();
            const std::size_t side = worseSide(part);
            const KeyStretch& stretch = sides_[side];
            if (!part.costs[side].split) {
                return;  // no further gain
            }
            parts_.pop();
            for (std::size_t s = 0; s < sides_.size(); ++s) {
                lost_[s] -= part.costs[s].lost;
            }
            const double share =
                (*part.costs[side].split - stretch.from) / (stretch.to - stretch.from);
            const double middle = stretch.reversed ? 1 - share : share;
            add(part.from, middle);
            add(middle, part.to);
        }
    }

    std::vector<double> starts() {
        std::vector<double> shares;
        shares.reserve(parts_.size() + 1);
        for (; !parts_.empty(); parts_.pop()) {
            shares.push_back(parts_.top().from);
        }
        std::ranges::sort(shares);
        return shares;
    }

    /// Removes stations that length and shape do not need, except the fixed ones.
    std::vector<double> thinned(std::vector<double> shares, const std::vector<double>& fixed) {
        std::vector<std::size_t> before(shares.size()), after(shares.size()), order;
        std::vector<double> saved(shares.size());
        for (std::size_t k = 0; k < shares.size(); ++k) {
            before[k] = k - 1;
            after[k] = k + 1;
            if (k > 0 && k + 1 < shares.size() && !std::ranges::binary_search(fixed, shares[k])) {
                saved[k] = measured(shares[k - 1], shares[k + 1]).lost();
                order.push_back(k);
            }
        }
        std::ranges::stable_sort(order, {}, [&](std::size_t k) { return saved[k]; });
        std::vector<bool> isGone(shares.size());
        for (const std::size_t k : order) {
            if (isSpared(shares[before[k]], shares[k], shares[after[k]])) {
                isGone[k] = true;
                after[before[k]] = after[k];
                before[after[k]] = before[k];
            }
        }
        std::vector<double> kept;
        for (std::size_t k = 0; k < shares.size(); ++k) {
            if (!isGone[k]) {
                kept.push_back(shares[k]);
            }
        }
        return kept;
    }

private:
    Part measured(double from, double to) const {
        Part part{from, to};
        for (std::size_t s = 0; s < sides_.size(); ++s) {
            const double a = sides_[s].at(from), b = sides_[s].at(to);
            part.costs[s] = chordCost(*sides_[s].line, std::min(a, b), std::max(a, b));
        }
        return part;
    }

    std::size_t worseSide(const Part& part) const {
        const auto isWorse = [&](double a, double b) -> bool { return b > a; };
        const bool second = part.far() > kKeyFar ? isWorse(part.costs[0].far, part.costs[1].far)
                                                 : isWorse(part.costs[0].lost, part.costs[1].lost);
        return second ? 1 : 0;
    }

    bool isSpared(double from, double at, double to) {
        const Part whole = measured(from, to), first = measured(from, at),
                   second = measured(at, to);
        if (whole.far() > kKeyFar) {
            return false;
        }
        double more[2] = {0, 0};
        for (std::size_t s = 0; s < sides_.size(); ++s) {
            more[s] = whole.costs[s].lost - first.costs[s].lost - second.costs[s].lost;
            if (lost_[s] + more[s] > kKeyLost) {
                return false;
            }
        }
        lost_[0] += more[0];
        lost_[1] += more[1];
        return true;
    }

    std::span<const KeyStretch> sides_;
    std::priority_queue<Part> parts_;
    double lost_[2] = {0, 0};  ///< mm, of each side
};

}  // namespace

std::vector<double> keyShares(std::span<const KeyStretch> sides, std::vector<double> fixed) {
    double shortest = sides.front().to - sides.front().from;
    for (const KeyStretch& side : sides) {
        shortest = std::min(shortest, side.to - side.from);
    }
    if (!(shortest > kSamePlace)) {
        return {0, 1};
    }
    const double same = kSamePlace / shortest;
    fixed.insert(fixed.end(), {0.0, 1.0});
    std::erase_if(fixed, [&](double share) {
        return !(share >= 0 && share <= 1) || (share > 0 && share < same) ||
               (share < 1 && share > 1 - same);
    });
    std::ranges::sort(fixed);
    fixed.erase(
        std::unique(fixed.begin(), fixed.end(), [&](double a, double b) { return b - a < same; }),
        fixed.end());
    Stations stations(sides);
    for (std::size_t k = 0; k + 1 < fixed.size(); ++k) {
        stations.add(fixed[k], fixed[k + 1]);
    }
    stations.refine();
    std::vector<double> shares = stations.starts();
    shares.push_back(1);
    return stations.thinned(std::move(shares), fixed);
}

namespace {

constexpr double kOnePlace = 1e-6;      // mm; coinciding ends of two neighbours on a line
constexpr double kEndCorner = 1e-3;     // mm; a corner where something ends
constexpr double kStraightTurn = 1e-6;  // radians
constexpr int kMinRunEdges = 3;

/// The key points of one line while they are gathered.
struct LineKeys {
    std::optional<geometry::Line> line{};  ///< none if the line has no key points
    KeyPoints fixed{};                     ///< ends, corners, straight runs; by `at`
    KeyPoints found{};
    std::vector<const DrawnEdge*> edges{};

    /// @param within  mm, distance in which an existing point replaces the new one
    void fix(double at, bool isTurn, double within) {
        const double place = line->wrap(at);
        const auto after = std::ranges::lower_bound(fixed, place, {}, &KeyPoint::at);
        if (!fixed.empty()) {
            const auto next = after == fixed.end() ? fixed.begin() : after;
            const auto before = std::prev(after == fixed.begin() ? fixed.end() : after);
            const auto known =
                line->apart(next->at, place) < line->apart(before->at, place) ? next : before;
            if (line->apart(known->at, place) < within) {
                known->isTurn |= isTurn;
                return;
            }
        }
        fixed.insert(after, {place, isTurn});
    }
};

/// Ends of long straight parts with several vertices.
void fixStraightRuns(LineKeys& keys) {
    const geometry::Line& line = *keys.line;
    const bool isClosed = line.isClosed();
    // Go twice round closed lines, from the first vertex with a turn.
    std::optional<int> start = isClosed ? std::nullopt : std::optional(0);
    const int end = isClosed ? 2 * line.count() : line.count();
    for (int k = 1; k < end; ++k) {
        const bool isEnd = !isClosed && k + 1 == end;
        if (!isEnd && std::abs(line.turnAt(k)) < kStraightTurn) {
            continue;
        }
        if (start && k - *start >= kMinRunEdges &&
            line.placeOf(k) - line.placeOf(*start) >= kStraightRun) {
            keys.fix(line.placeOf(*start), false, kEndCorner);
            keys.fix(line.placeOf(k), false, kEndCorner);
        }
        start = k;
    }
}

void fixCorners(LineKeys& keys, const DrawnPath& path) {
    const geometry::Line& line = *keys.line;
    if (path.closed) {
        if (path.points.rows() >= 3 && line.length() > 0) {
            for (const int k : findCorners(path.points)) {
                keys.fix(line.arc()[k], true, kEndCorner);
            }
        }
        return;
    }
    keys.fix(0, true, kOnePlace);
    keys.fix(line.length(), true, kOnePlace);
    for (int k = 1; k + 1 < line.count(); ++k) {
        if (std::abs(line.turnAt(k)) > kLineCorner.turn) {
            keys.fix(line.arc()[k], true, kEndCorner);
        }
    }
}

/// Ends of segments on the drawn seam line: mirrored, it runs in the opposite direction.
void fixSegments(LineKeys& keys, const PatternPiece& piece, const Placement& placement) {
    const auto outline = geometry::Line::closed(piece.outline);
    for (const PatternSegment& segment : piece.segments) {
        const double at =
            placement.mirrored ? outline.arc()[outline.count() - 1] - segment.from : segment.from;
        keys.fix(at, true, kEndCorner);
    }
}

/// Direction and fold ends of an edge of a drawing in its seam.
struct EdgeFacts {
    bool mirrored = false;           ///< drawn from its end to its beginning
    std::array<bool, 2> isAtFold{};  ///< as drawn
};

std::vector<EdgeFacts> edgeFacts(const Drawing& drawing, const Pattern& pattern) {
    std::vector<EdgeFacts> facts(drawing.edges.size());
    for (const DrawnBlock& block : drawing.blocks) {
        const PatternPiece& piece = pattern.pieces[static_cast<std::size_t>(block.piece)];
        const bool isMirrored = block.placement.mirrored;
        for (std::size_t e = block.edge; e < block.edge + block.edgeCount; ++e) {
            facts[e].mirrored = isMirrored;
            for (const SeamLine& seam : piece.seams) {
                if (piece.cutAs == CutAs::OnFold && seam.number == drawing.edges[e].number) {
                    const std::size_t first = isMirrored ? 1 : 0;
                    facts[e].isAtFold[0] |= seam.isAtFold[first];
                    facts[e].isAtFold[1] |= seam.isAtFold[1 - first];
                }
            }
        }
    }
    return facts;
}

/// Whether both sides of a seam run in the same direction along the outlines of their pieces.
bool runsAlike(const Garment& garment, int number) {
    const auto index = static_cast<std::size_t>(number) - 1;
    if (number < 1 || index >= garment.seams.seams.size()) {
        return false;
    }
    const Seam& seam = garment.seams.seams[index];
    return seam.left.reversed == seam.right.reversed;
}

class KeyPointFinder {
public:
    KeyPointFinder(const Drawing& drawing, const Pattern& pattern, const Garment& garment)
        : drawing_(drawing),
          garment_(garment),
          lines_(drawing.paths.size()),
          facts_(edgeFacts(drawing, pattern)) {
        for (std::size_t k = 0; k < lines_.size(); ++k) {
            const DrawnPath& path = drawing.paths[k];
            if (path.points.rows() > 0 &&
                (path.layer == LayerKind::Cut || path.layer == LayerKind::Sew ||
                 path.layer == LayerKind::Internal)) {
                lines_[k].line.emplace(path.points, path.closed);
            }
        }
        fixPlaces(pattern);
    }

    std::vector<KeyPoints> found() {
        std::vector<bool> isDone(drawing_.edges.size());
        for (std::size_t e = 0; e < isDone.size(); ++e) {
            if (!isDone[e] && hasLine(e)) {
                const std::optional<std::size_t> other = partner(e);
                addSeam(e, other);
                isDone[e] = true;
                if (other) {
                    isDone[*other] = true;
                }
            }
        }
        std::vector<KeyPoints> all;
        all.reserve(lines_.size());
        for (LineKeys& keys : lines_) {
            if (keys.line) {
                addRest(keys);
            }
            all.push_back(inOrder(keys));
        }
        return all;
    }

private:
    bool hasLine(std::size_t edge) const {
        const int path = drawing_.edges[edge].path;
        return path >= 0 && lines_[static_cast<std::size_t>(path)].line.has_value();
    }

    void fixPlaces(const Pattern& pattern) {
        for (std::size_t e = 0; e < drawing_.edges.size(); ++e) {
            if (hasLine(e)) {
                const DrawnEdge& edge = drawing_.edges[e];
                LineKeys& keys = lines_[static_cast<std::size_t>(edge.path)];
                keys.fix(edge.from, true, kOnePlace);
                keys.fix(edge.to, true, kOnePlace);
                keys.edges.push_back(&edge);
            }
        }
        for (const DrawnBlock& block : drawing_.blocks) {
            const PatternPiece& piece = pattern.pieces[static_cast<std::size_t>(block.piece)];
            const std::size_t seamLine = block.path + (piece.cuttingLine.rows() > 0 ? 1 : 0);
            if (seamLine < lines_.size() && lines_[seamLine].line) {
                fixSegments(lines_[seamLine], piece, block.placement);
            }
        }
        for (std::size_t k = 0; k < lines_.size(); ++k) {
            if (lines_[k].line) {
                fixCorners(lines_[k], drawing_.paths[k]);
                fixStraightRuns(lines_[k]);
            }
        }
    }

    bool isReversed(std::size_t edge, std::size_t other) const {
        const bool alike = runsAlike(garment_, drawing_.edges[edge].number);
        return alike == (facts_[edge].mirrored != facts_[other].mirrored);
    }

    /// The other side of its seam, if equal shares of both correspond.
    std::optional<std::size_t> partner(std::size_t edge) const {
        const DrawnEdge& own = drawing_.edges[edge];
        if (own.pair.empty()) {
            return {};
        }
        for (std::size_t other = 0; other < drawing_.edges.size(); ++other) {
            if (drawing_.edges[other].id == own.pair && hasLine(other)) {
                std::array<bool, 2> ends = facts_[other].isAtFold;
                if (isReversed(edge, other)) {
                    std::swap(ends[0], ends[1]);
                }
                return ends == facts_[edge].isAtFold ? std::optional(other) : std::nullopt;
            }
        }
        return {};
    }

    KeyStretch stretchOf(std::size_t edge, bool reversed) const {
        const DrawnEdge& drawn = drawing_.edges[edge];
        return {&*lines_[static_cast<std::size_t>(drawn.path)].line, drawn.from, drawn.to,
                reversed};
    }

    void addSeam(std::size_t edge, std::optional<std::size_t> other) {
        std::vector<KeyStretch> sides{stretchOf(edge, false)};
        std::vector<LineKeys*> keys{&keysOf(edge)};
        if (other) {
            sides.push_back(stretchOf(*other, isReversed(edge, *other)));
            keys.push_back(&keysOf(*other));
        }
        addStations(sides, keys);
    }

    LineKeys& keysOf(std::size_t edge) {
        return lines_[static_cast<std::size_t>(drawing_.edges[edge].path)];
    }

    static void addStations(const std::vector<KeyStretch>& sides,
                            const std::vector<LineKeys*>& keys) {
        std::vector<double> fixed;
        for (std::size_t s = 0; s < sides.size(); ++s) {
            const KeyStretch& side = sides[s];
            for (const KeyPoint& point : keys[s]->fixed) {
                const double way = keys[s]->line->wrap(point.at - side.from);
                const double share = way / (side.to - side.from);
                if (share > 0 && share < 1) {
                    fixed.push_back(side.reversed ? 1 - share : share);
                }
            }
        }
        for (const double share : keyShares(sides, std::move(fixed))) {
            for (std::size_t s = 0; s < sides.size(); ++s) {
                keys[s]->found.push_back({keys[s]->line->wrap(sides[s].at(share)), false});
            }
        }
    }

    /// Adds the stretches that are not a side of a seam, between consecutive turn points.
    static void addRest(LineKeys& keys) {
        std::vector<double> ends;
        for (const KeyPoint& point : keys.fixed) {
            if (point.isTurn) {
                ends.push_back(point.at);
            }
        }
        if (ends.empty()) {
            ends.push_back(keys.fixed.empty() ? 0 : keys.fixed.front().at);
        }
        if (keys.line->isClosed()) {
            ends.push_back(ends.front() + keys.line->length());
        }
        for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
            const double middle = 0.5 * (ends[k] + ends[k + 1]);
            const bool isSeam = std::ranges::any_of(keys.edges, [&](const DrawnEdge* edge) {
                return keys.line->wrap(middle - edge->from) < edge->to - edge->from;
            });
            if (!isSeam) {
                addStations({{&*keys.line, ends[k], ends[k + 1]}}, {&keys});
            }
        }
    }

    /// Each place once, starting at a turn point.
    static KeyPoints inOrder(const LineKeys& keys) {
        if (!keys.line) {
            return {};
        }
        KeyPoints all = keys.fixed;
        all.insert(all.end(), keys.found.begin(), keys.found.end());
        std::ranges::stable_sort(all, {}, &KeyPoint::at);
        KeyPoints once;
        for (const KeyPoint& point : all) {
            if (!once.empty() && point.at - once.back().at < kOnePlace) {
                once.back().isTurn |= point.isTurn;
            } else {
                once.push_back(point);
            }
        }
        if (keys.line->isClosed() && once.size() > 1 &&
            keys.line->apart(once.front().at, once.back().at) < kOnePlace) {
            once.front().isTurn |= once.back().isTurn;
            once.pop_back();
        }
        const auto turn = std::ranges::find(once, true, &KeyPoint::isTurn);
        if (keys.line->isClosed() && turn != once.end()) {
            std::rotate(once.begin(), turn, once.end());
        }
        return once;
    }

    const Drawing& drawing_;
    const Garment& garment_;
    std::vector<LineKeys> lines_;
    std::vector<EdgeFacts> facts_;
};

}  // namespace

std::vector<KeyPoints> keyPoints(const Drawing& drawing, const Pattern& pattern,
                                 const Garment& garment) {
    return KeyPointFinder(drawing, pattern, garment).found();
}

}  // namespace toile
