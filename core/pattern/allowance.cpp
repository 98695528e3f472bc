// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/allowance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <polyclipping/clipper.hpp>

#include "core/geometry/segment.h"

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

}  // namespace toile
