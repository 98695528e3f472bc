// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/piece_allowance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include <polyclipping/clipper.hpp>

#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/pattern/darts.h"
#include "core/pattern/extension.h"

namespace toile {
namespace {

using ClipperLib::Path;
using ClipperLib::Paths;
using Eigen::Vector2d;

constexpr double kGrid = 2e-6;       // mm: integer unit of the Clipper library
constexpr double kCurveLimit = 1.2;  // of mitres within a stretch

/// An edge of the seam line with its allowance.
struct SeamEdge {
    Vector2d from;
    Vector2d along = Vector2d::Zero();  ///< unit length
    double length = 0, width = 0;
    int stretch = 0;
    bool begins = false;     ///< a stretch starts here
    bool isCutBack = false;  ///< by the corner at an end of the stretch, or near it

    Vector2d outward() const { return -geometry::leftOf(along); }
    Vector2d offset() const { return width * outward(); }
    AllowanceSide atEnd() const { return {along, outward(), width, length}; }
    AllowanceSide atStart() const { return {-along, outward(), width, length}; }
};

/// The edges of non-zero length.
std::vector<SeamEdge> seamEdges(const Points2& line,
                                const std::vector<AllowanceStretch>& stretches) {
    std::vector<SeamEdge> edges;
    edges.reserve(static_cast<std::size_t>(line.rows()));
    const int count = static_cast<int>(stretches.size());
    int next = 0;  // the stretch that starts next
    for (int k = 0; k < line.rows(); ++k) {
        const Vector2d at = line.row(k);
        const bool begins = next < count && stretches[next].first == k;
        next += begins ? 1 : 0;
        if (edges.empty() || (at - edges.back().from).norm() >= kShortestSeamEdge) {
            edges.push_back({at});
        }
        edges.back().stretch = next > 0 ? next - 1 : count - 1;
        edges.back().begins = edges.back().begins || begins;
    }
    while (edges.size() > 1 &&
           (edges.front().from - edges.back().from).norm() < kShortestSeamEdge) {
        edges.front().begins = edges.front().begins || edges.back().begins;
        edges.pop_back();
    }
    for (std::size_t k = 0; k < edges.size(); ++k) {
        const Vector2d edge = edges[(k + 1) % edges.size()].from - edges[k].from;
        const double width = stretches[edges[k].stretch].width;
        edges[k].length = edge.norm();
        edges[k].along = edge.normalized();
        edges[k].width = width < kAllowanceOverlap ? 0 : width;
    }
    return edges;
}

/// The plane in integer coordinates.
class Grid {
public:
    explicit Grid(const Points2& line)
        : centre_((line.colwise().minCoeff() + line.colwise().maxCoeff()).transpose() / 2) {}

    void add(const Vector2d& point, Path& path) const {
        const Vector2d steps = (point - centre_) / kGrid;
        path.emplace_back(std::llround(steps.x()), std::llround(steps.y()));
    }
    Points2 points(const Path& path) const {
        Points2 points(path.size(), 2);
        for (Eigen::Index k = 0; k < points.rows(); ++k) {
            const Vector2d steps(static_cast<double>(path[k].X), static_cast<double>(path[k].Y));
            points.row(k) = centre_ + kGrid * steps;
        }
        return points;
    }

private:
    Vector2d centre_;
};

/// Clips closed lines; an area is covered if any line winds around it.
Paths clipped(ClipperLib::ClipType type, const Paths& subjects, const Paths& clips) {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(subjects, ClipperLib::ptSubject, true);
    clipper.AddPaths(clips, ClipperLib::ptClip, true);
    Paths result;
    clipper.Execute(type, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    return result;
}

/// The piece with its allowances as closed lines, always anti-clockwise, which may go round some
/// parts several times.
class Allowances {
public:
    Allowances(std::vector<SeamEdge> edges, const std::vector<AllowanceStretch>& stretches,
               const Grid& grid)
        : edges_(std::move(edges)), grid_(grid), cuts_(stretches.size()) {
        joins_.reserve(edges_.size());
        for (int k = 0; k < size(); ++k) {
            joins_.push_back(joinAt(k, stretches));
            if (!joins_.back().cut.empty()) {
                cutBack(k, joins_.back());
            }
        }
    }

    /// A line around everything that is not cut back, and lines around the rest of the other
    /// allowances. Parts overlap or share points, because rounding would otherwise leave slits.
    Paths lines() const {
        Paths lines{lineAround([](const SeamEdge& /*edge*/) { return false; }),
                    lineAround([](const SeamEdge& edge) { return !edge.isCutBack; })};
        for (int k = 0; k < static_cast<int>(cuts_.size()); ++k) {
            if (!cuts_[k].empty()) {
                const Path whole = lineAround(
                    [k](const SeamEdge& edge) { return edge.isCutBack && edge.stretch == k; });
                const Paths left = clipped(ClipperLib::ctDifference, {whole}, cuts_[k]);
                lines.insert(lines.end(), left.begin(), left.end());
            }
        }
        return lines;
    }

private:
    int size() const { return static_cast<int>(edges_.size()); }
    int wrap(int k) const { return (k + size()) % size(); }
    const SeamEdge& edge(int k) const { return edges_[wrap(k)]; }

    CornerJoin joinAt(int k, const std::vector<AllowanceStretch>& stretches) const {
        const bool corner = edge(k).begins;
        return joinAllowances(edge(k - 1).atEnd(), edge(k).atStart(),
                              corner ? stretches[edge(k).stretch].corner : CornerRule::Mitre,
                              corner ? kMitreLimit : kCurveLimit);
    }

    /// Records the area that the corner at the start of edge k cuts back.
    void cutBack(int k, const CornerJoin& join) {
        const int step = join.cutsFirst ? -1 : 1;
        int at = wrap(join.cutsFirst ? k - 1 : k);
        Path cut;
        add(k, join.cut, cut);
        cuts_[edges_[at].stretch].push_back(std::move(cut));
        for (double reached = 0; reached < join.reach; at = wrap(at + step)) {
            edges_[at].isCutBack = true;
            reached += edges_[at].length;
            if (edge(join.cutsFirst ? at : at + 1).begins) {
                break;  // the stretch ends
            }
        }
    }

    void add(int k, const std::vector<Vector2d>& places, Path& path) const {
        for (const Vector2d& place : places) {
            grid_.add(edge(k).from + place, path);
        }
    }

    /// A line around the piece and the allowances of some edges.
    template <class HasAllowance>
    Path lineAround(const HasAllowance& has) const {
        Path path;
        for (int k = 0; k < size(); ++k) {
            addJoin(k, has(edge(k - 1)), has(edge(k)), path);
        }
        return path;
    }

    /// The join at the start of edge k, through the corner if an allowance is left out.
    void addJoin(int k, bool withFirst, bool withSecond, Path& path) const {
        const SeamEdge &first = edge(k - 1), &second = edge(k);
        const CornerJoin& join = joins_[k];
        const bool cutsFirst = !join.cut.empty() && join.cutsFirst;
        const bool cutsSecond = !join.cut.empty() && !join.cutsFirst;
        const auto addIf = [&](bool wanted, const Vector2d& place) {
            if (wanted) {
                add(k, {place}, path);
            }
        };
        const Vector2d corner = Vector2d::Zero();
        const Vector2d firstEnd = first.offset() + kAllowanceOverlap * first.along;
        const Vector2d secondEnd = second.offset() - kAllowanceOverlap * second.along;
        // Allowances that overlap, or are to be cut, are complete, each without the other.
        const bool overlapping = geometry::cross(first.along, second.along) < 1e-6;
        const bool apart = overlapping && withFirst != withSecond;
        const bool endsFirst = withFirst && (cutsFirst || apart);
        const bool startsSecond = withSecond && (cutsSecond || apart);
        const bool fromFirst = withFirst && !endsFirst, toSecond = withSecond && !startsSecond;
        addIf(endsFirst, firstEnd);
        addIf(!fromFirst, corner);
        if (fromFirst || toSecond) {
            const bool skipsFirst = !fromFirst && join.stepsFirst;
            const bool skipsSecond = !toSecond && join.stepsSecond;
            addIf(!fromFirst && !cutsFirst && !skipsFirst, first.offset());
            const auto begin = join.path.begin() + (skipsFirst ? 1 : 0);
            add(k, std::vector<Vector2d>(begin, join.path.end() - (skipsSecond ? 1 : 0)), path);
            addIf(!toSecond && !cutsSecond && !skipsSecond, second.offset());
            addIf(!toSecond, corner);
        }
        addIf(startsSecond, secondEnd);
    }

    std::vector<SeamEdge> edges_;
    const Grid& grid_;
    std::vector<CornerJoin> joins_;  ///< at the start of each edge
    std::vector<Paths> cuts_;        ///< of each stretch
};

}  // namespace

Points2 cuttingLine(const Points2& seamLine, const std::vector<AllowanceStretch>& stretches) {
    const Grid grid(seamLine);
    const Allowances allowances(seamEdges(seamLine, stretches), stretches, grid);
    Paths lines = clipped(ClipperLib::ctUnion, allowances.lines(), {});
    // Again: crossings rounded to the grid may make lines cross once more, by less than a step.
    lines = clipped(ClipperLib::ctUnion, lines, {});
    const auto outer = std::max_element(
        lines.begin(), lines.end(),
        [](const Path& a, const Path& b) { return ClipperLib::Area(a) < ClipperLib::Area(b); });
    return grid.points(*outer);
}

namespace {

constexpr double kNoStretch = 1e-6;  // mm: shorter remainders are rounding

/// A part of a segment, or a cap; the capped line is a sequence of these.
struct LineItem {
    Points2 points;
    int segment = -1;                ///< of a part
    const PieceDart* cap = nullptr;  ///< null: it is a part
    std::size_t owner = 0;           ///< the part whose stretch it belongs to
};

/// The parts of segments on a stretch of outline, in order.
void addParts(const PatternPiece& piece, const geometry::Line& outline, double from, double to,
              std::vector<LineItem>& items) {
    struct Part {
        double from = 0, to = 0;
        int segment = -1;
    };
    std::vector<Part> parts;
    const int count = static_cast<int>(piece.segments.size());
    for (int k = 0; k < count; ++k) {
        for (const auto& part : geometry::commonParts(
                 {from, to}, {piece.segments[k].from, piece.segments[k].to}, outline.length())) {
            if (part.length() > kNoStretch) {
                parts.push_back({part.low, part.high, k});
            }
        }
    }
    if (parts.empty() && to - from > kNoStretch) {
        parts.push_back({from, to, -1});
    }
    std::ranges::stable_sort(parts, {}, &Part::from);
    for (const Part& part : parts) {
        items.push_back({outline.part(part.from, part.to), part.segment, nullptr, 0});
    }
}

/// A cap belongs to the part beyond the leg over which it is laid.
void setOwners(std::vector<LineItem>& items) {
    const std::size_t n = items.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t at = k;
        if (items[k].cap) {
            const std::size_t step = items[k].cap->lay == DartLay::First ? n - 1 : 1;
            do {
                at = (at + step) % n;
            } while (items[at].cap && at != k);
        }
        items[k].owner = at;
    }
}

}  // namespace

CappedOutline cappedOutline(const PatternPiece& piece, const std::vector<PieceDart>& darts) {
    CappedOutline capped;
    if (piece.outline.rows() < 3) {
        return capped;
    }
    const auto outline = geometry::Line::closed(piece.outline);
    std::vector<const PieceDart*> caps;
    for (const PieceDart& dart : darts) {
        if (dart.cap.rows() > 1) {
            caps.push_back(&dart);
        }
    }
    std::ranges::stable_sort(caps, {}, [](const PieceDart* dart) { return dart->from; });
    std::vector<LineItem> items;
    if (caps.empty()) {
        const double from = piece.segments.empty() ? 0 : piece.segments.front().from;
        addParts(piece, outline, from, from + outline.length(), items);
    }
    for (std::size_t k = 0; k < caps.size(); ++k) {
        const PieceDart& next = *caps[(k + 1) % caps.size()];
        const double turn = k + 1 == caps.size() ? outline.length() : 0;
        addParts(piece, outline, caps[k]->to, next.from + turn, items);
        items.push_back({next.cap, -1, &next, 0});
    }
    setOwners(items);

    std::vector<Eigen::RowVector2d> points;
    for (std::size_t k = 0; k < items.size(); ++k) {
        const LineItem& item = items[k];
        if (item.owner != items[(k + items.size() - 1) % items.size()].owner) {
            capped.stretches.push_back(
                {static_cast<int>(points.size()), items[item.owner].segment});
        }
        // The last point is the first of the next item. Skip points that coincide with a neighbour.
        const Eigen::Index last = item.points.rows() - 1;
        points.emplace_back(item.points.row(0));
        for (Eigen::Index i = 1; i < last; ++i) {
            if ((item.points.row(i) - points.back()).norm() > kNoStretch &&
                (item.points.row(i) - item.points.row(last)).norm() > kNoStretch) {
                points.emplace_back(item.points.row(i));
            }
        }
    }
    if (capped.stretches.empty() && !items.empty()) {
        capped.stretches.push_back({0, items[items.front().owner].segment});
    }
    capped.line.resize(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t k = 0; k < points.size(); ++k) {
        capped.line.row(static_cast<Eigen::Index>(k)) = points[k];
    }
    return capped;
}

namespace {

bool isFreeEdge(const PatternSegment& segment) {
    return segment.seam > 0 && segment.kind == SeamKind::Free && !segment.isFaced;
}

/// Whether the allowance is folded up along the edge.
bool isTurnedUp(const PatternSegment& segment) {
    return isFreeEdge(segment) &&
           (segment.edge == EdgeKind::Hem || segment.edge == EdgeKind::Cuff ||
            segment.edge == EdgeKind::Slit || segment.edge == EdgeKind::Unknown);
}

}  // namespace

double AllowanceWidths::widthOf(EdgeKind kind) const {
    constexpr double kCuff = 25, kSlit = 15, kCurved = 7;
    const bool isHem = kind == EdgeKind::Hem || kind == EdgeKind::Unknown;
    const bool isCurved = kind == EdgeKind::Neckline || kind == EdgeKind::Armhole;
    return of(kind).value_or(isHem                    ? hem
                             : kind == EdgeKind::Cuff ? std::min(kCuff, hem)
                             : kind == EdgeKind::Slit ? std::min(kSlit, hem)
                             : isCurved               ? std::min(kCurved, seam)
                                                      : seam);
}

double usualAllowance(const PatternSegment& segment, const AllowanceWidths& widths) {
    switch (segment.kind) {
        case SeamKind::Fold:
        case SeamKind::Dart:
            return 0;
        case SeamKind::Free:  // too short to be a free edge, or faced: treat as a seam
            return isFreeEdge(segment) ? widths.widthOf(segment.edge) : widths.seam;
        case SeamKind::Seam:
            break;
    }
    return widths.seam;
}

namespace {

/// Width of a piece beside a segment: the lower quartile of distances straight across it, mm.
double widthBeside(const geometry::Line& outline, const PatternSegment& segment) {
    constexpr int kRays = 12;
    constexpr double kBeside = 1e-3;  // mm: nearer crossings are the segment itself
    std::vector<double> widths;
    for (int k = 0; k < kRays; ++k) {
        const double at = segment.from + (segment.to - segment.from) * (k + 3) / (kRays + 5);
        const Vector2d from = outline.pointAt(at);
        const Vector2d along = (outline.pointAt(at + 1) - outline.pointAt(at - 1)).transpose();
        const Vector2d inward = geometry::leftOf(Vector2d(along.normalized()));
        double nearest = std::numeric_limits<double>::infinity();
        for (int i = 0; i < outline.count(); ++i) {
            const Vector2d a = outline.point(i).transpose() - from;
            const Vector2d edge = outline.point(i + 1).transpose() - from - a;
            const double sine = geometry::cross(inward, edge);
            const double share = -geometry::cross(inward, a) / sine;
            const double distance = geometry::cross(a, edge) / sine;
            if (sine != 0 && share >= 0 && share <= 1 && distance > kBeside) {
                nearest = std::min(nearest, distance);
            }
        }
        widths.push_back(nearest);
    }
    std::ranges::sort(widths);
    return widths[widths.size() / 4];
}

/// The turn of the line within a segment, radians, positive to the left.
double turnWithin(const geometry::Line& outline, const PatternSegment& segment) {
    double turn = 0;
    for (int k = outline.firstAfter(segment.from); outline.placeOf(k) < segment.to - kNoStretch;
         ++k) {
        turn += outline.turnAt(k);
    }
    return turn;
}

}  // namespace

void limitAllowances(std::vector<PatternPiece>& pieces) {
    constexpr double kCurved = 0.03, kTurnedUp = 0.1, kWhole = 0.5;
    constexpr double kMinCurved = 5, kMinTurnedUp = 10;  // mm: less cannot be sewn
    const auto isLimited = [](const PatternSegment& segment) {
        return isFreeEdge(segment) && !segment.isAllowanceSet && segment.allowance > 0;
    };
    constexpr double kOwnShare = 0.05;  // of all: shorter edges are not judged alone
    const auto isCurved = [](const PatternSegment& segment) {
        return segment.edge == EdgeKind::Neckline || segment.edge == EdgeKind::Armhole ||
               segment.edge == EdgeKind::Collar;
    };
    struct FreeEdges {
        double length = 0, turn = 0;
        std::vector<std::pair<double, double>> each{};  ///< lengths and turns of curved edges

        /// Turn per length, 1/mm: of the whole, or of the curved edge that turns most.
        double curvature() const {
            double most = std::max(std::abs(turn) / length, 1e-12);
            for (const auto& [own, turned] : each) {
                most = own < kOwnShare * length ? most : std::max(most, std::abs(turned) / own);
            }
            return most;
        }
    };
    // One width for all necklines, armholes or collars: widths meet at the shoulders, and both
    // sides of a garment are alike.
    const auto keyOf = [&](const PatternSegment& segment) {
        return std::pair(isCurved(segment) ? -1 : segment.opening, segment.edge);
    };
    std::map<std::pair<int, EdgeKind>, FreeEdges> openings;
    for (PatternPiece& piece : pieces) {
        if (piece.outline.rows() < 3) {
            continue;
        }
        const auto outline = geometry::Line::closed(piece.outline);
        const bool isTiny = geometry::signedAreaOf(piece.outline) < kMinAllowanceArea;
        for (PatternSegment& segment : piece.segments) {
            if (isTiny && !segment.isAllowanceSet && segment.allowance > 0) {
                segment.allowance = 0;
                segment.limit = AllowanceLimit::Size;
            }
            if (isLimited(segment)) {
                FreeEdges& edges = openings[keyOf(segment)];
                const double length = segment.to - segment.from;
                const double turn = turnWithin(outline, segment);
                edges.length += length;
                edges.turn += turn;
                if (isCurved(segment)) {
                    edges.each.emplace_back(length, turn);
                }
            }
        }
    }
    for (PatternPiece& piece : pieces) {
        for (PatternSegment& segment : piece.segments) {
            if (piece.outline.rows() < 3 || !isLimited(segment)) {
                continue;
            }
            const auto narrow = [&segment](double width, AllowanceLimit limit) {
                // Rounding may not separate the two sides of a mirrored piece.
                width = kWhole * std::floor(width / kWhole + 1e-6);
                if (width < segment.allowance) {
                    segment.allowance = width;
                    segment.limit = limit;
                }
            };
            narrow(widthBeside(geometry::Line::closed(piece.outline), segment) / 2,
                   AllowanceLimit::Width);
            const FreeEdges& edges = openings.at(keyOf(segment));
            const bool curved = isCurved(segment);
            if (curved || isTurnedUp(segment)) {
                narrow(std::max(curved ? kMinCurved : kMinTurnedUp,
                                (curved ? kCurved : kTurnedUp) / edges.curvature()),
                       AllowanceLimit::Curve);
            }
        }
    }
}

CornerRule cornerOf(const PatternPiece& piece, std::size_t k) {
    const PatternSegment& segment = piece.segments[k];
    const std::size_t count = piece.segments.size();
    std::size_t before = (k + count - 1) % count;
    while (before != k && piece.segments[before].kind == SeamKind::Dart) {
        before = (before + count - 1) % count;  // the line continues over the closed dart
    }
    const bool afterHem = isTurnedUp(piece.segments[before]);
    if (segment.corner || afterHem == isTurnedUp(segment)) {
        return segment.corner.value_or(CornerRule::Mitre);
    }
    return afterHem ? CornerRule::MirrorFirst : CornerRule::MirrorSecond;
}

AllowanceBase allowanceBase(const PatternPiece& piece, CappedOutline outline) {
    AllowanceBase base{std::move(outline.line), {}};
    base.stretches.reserve(outline.stretches.size());
    for (const CappedStretch& stretch : outline.stretches) {
        const auto k = static_cast<std::size_t>(stretch.segment);
        base.stretches.push_back(
            stretch.segment < 0
                ? AllowanceStretch{stretch.first, 0, CornerRule::Mitre}
                : AllowanceStretch{stretch.first, piece.segments[k].allowance, cornerOf(piece, k)});
    }
    return base;
}

void addCuttingLine(PatternPiece& piece) {
    piece.darts = findDarts(piece);
    CappedOutline outline = extendedOutline(piece, cappedOutline(piece, piece.darts));
    piece.extensions = extensionEdges(piece, outline);
    AllowanceBase base = allowanceBase(piece, std::move(outline));
    const bool isNone = std::ranges::all_of(
        base.stretches, [](const AllowanceStretch& stretch) { return stretch.width == 0; });
    piece.cuttingLine = isNone ? std::move(base.line) : cuttingLine(base.line, base.stretches);
}

void setCutting(PatternPiece& piece, const Cutting& cutting) {
    const bool isTurned = grainOf(piece) != grainOf(cutting);
    static_cast<Cutting&>(piece) = cutting;
    if (isTurned && !piece.darts.empty()) {
        addCuttingLine(piece);
    }
}

int segmentAt(const PatternPiece& piece, double length, double at) {
    const auto contains = [&](double slack) {
        return std::ranges::find_if(piece.segments, [&](const PatternSegment& segment) {
            // A segment may pass the outline's first point: also test a turn later.
            return (at >= segment.from - slack && at < segment.to + slack) ||
                   (at + length >= segment.from - slack && at + length < segment.to + slack);
        });
    };
    constexpr double kRounding = 1e-6;  // mm: between a segment's end and the next one's start
    auto found = contains(0);
    found = found != piece.segments.end() ? found : contains(kRounding);
    if (found == piece.segments.end()) {
        return -1;
    }
    const auto k = static_cast<int>(found - piece.segments.begin());
    return found->isFold && k > 0 ? k - 1 : k;  // a half ends with the segment before the fold
}

double allowanceAt(const PatternPiece& piece, double length, double at) {
    const int segment = segmentAt(piece, length, at);
    return segment < 0 ? 0 : piece.segments[segment].allowance;
}

}  // namespace toile
