// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/segment_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

namespace toile::geometry {
namespace {

/// A cell is halved if its sweep leaves more than this many pairs per segment.
constexpr std::size_t kPairsEach = 8;
/// Cells with fewer segments are not worth dividing.
constexpr std::size_t kFewSegments = 12;
constexpr int kMaxDepth = 48;
/// If a halving leaves less than this part of the pairs, the other direction is not tried: segments
/// side by side leave a half.
constexpr double kGoodHalving = 0.6;
/// Limit on how many pairs divisions within a cell may add, as a multiple of its pairs. Segments
/// that coincide are in every part of a cell that they pass, however often it is divided.
constexpr double kMaxGrowth = 1;

/// The extent of a segment within a cell, measured across the sweep.
struct Span {
    double low, high;
    int segment;
};

/// Clips a segment that was clipped to the parent cell to this cell plus the margin; false if
/// nothing is left.
bool clip(Segment2& part, const PlaneCell& cell, double margin) {
    const double side = cell.isBeyond ? 1 : -1;
    const double a = side * (part.a.dot(cell.across) - cell.at) + margin;
    const double b = side * (part.b.dot(cell.across) - cell.at) + margin;
    if (a < 0 && b < 0) {
        return false;
    }
    if (a < 0 || b < 0) {
        (a < 0 ? part.a : part.b) = part.a + a / (a - b) * (part.b - part.a);
    }
    return true;
}

/// Doubles the angle, so that opposite directions are equal.
Eigen::RowVector2d doubledDirection(const Segment2& s) {
    const Eigen::RowVector2d d = s.b - s.a;
    const double length = d.norm();
    return length > 0
               ? Eigen::RowVector2d(
                     Eigen::RowVector2d(d.x() * d.x() - d.y() * d.y(), 2 * d.x() * d.y()) / length)
               : Eigen::RowVector2d(0, 0);
}

class Search {
public:
    Search(const std::vector<Segment2>& segments, double margin, const PairVisitor& visit)
        : margin_(margin), visit_(visit) {
        doubled_.reserve(segments.size());
        std::ranges::transform(segments, std::back_inserter(doubled_), doubledDirection);
    }

    bool run(const std::vector<Segment2>& segments) const {
        Content all;
        all.parts = segments;
        all.here.resize(segments.size());
        std::iota(all.here.begin(), all.here.end(), 0);
        sweep(all);
        double spare = kMaxGrowth * static_cast<double>(all.pairs);
        return inCell(all, 0, spare);
    }

private:
    /// The contents of a cell.
    struct Content {
        PlaneCell cell;
        std::vector<int> here;        ///< segments
        std::vector<Segment2> parts;  ///< the part of each segment in the cell
        Eigen::RowVector2d across;    ///< the direction of the sweep
        std::vector<Span> spans;
        std::size_t pairs = 0;  ///< that the sweep leaves
    };
    using Halves = std::array<Content, 2>;

    void sweep(Content& content) const {
        content.across = mostlyAcross(content.here);
        content.spans = spansAlong(content);
        content.pairs = overlaps(content.spans);
    }

    /// The segments on either side of a line through the mean of their midpoints.
    Halves halvesAcross(const Content& content, const Eigen::RowVector2d& across) const {
        std::vector<double> midpoints;
        midpoints.reserve(content.parts.size());
        for (const Segment2& part : content.parts) {
            midpoints.push_back(0.5 * (part.a + part.b).dot(across));
        }
        const auto median = midpoints.begin() + static_cast<std::ptrdiff_t>(midpoints.size() / 2);
        std::ranges::nth_element(midpoints, median);
        Halves halves;
        for (const bool beyond : {false, true}) {
            Content& half = halves[beyond ? 1 : 0];
            half.cell = {&content.cell, across, *median, beyond};
            for (std::size_t k = 0; k < content.parts.size(); ++k) {
                Segment2 part = content.parts[k];
                if (clip(part, half.cell, margin_)) {
                    half.parts.push_back(part);
                    half.here.push_back(content.here[k]);
                }
            }
            sweep(half);
        }
        return halves;
    }

    /// Halved so that few pairs are left. The half with fewer comes first: the pairs that its
    /// division saves are spare for the other.
    Halves halvesOf(const Content& content) const {
        const Eigen::RowVector2d along(-content.across.y(), content.across.x());
        Halves halves = halvesAcross(content, content.across);
        const auto left = [](const Halves& of) { return of[0].pairs + of[1].pairs; };
        if (static_cast<double>(left(halves)) > kGoodHalving * static_cast<double>(content.pairs)) {
            Halves others = halvesAcross(content, along);
            if (left(others) < left(halves)) {
                halves = std::move(others);
            }
        }
        if (halves[1].pairs < halves[0].pairs) {
            std::swap(halves[0], halves[1]);
        }
        return halves;
    }

    /// @param spare  by how many pairs the divisions around this cell may still exceed the number
    ///               before; reduced by the pairs added in this cell, increased by those saved
    bool inCell(const Content& content, int depth, double& spare) const {
        if (depth == kMaxDepth || content.here.size() < kFewSegments ||
            content.pairs <= kPairsEach * content.here.size()) {
            return visitOverlaps(content.spans, content.cell);
        }
        const Halves halves = halvesOf(content);
        const double added = static_cast<double>(halves[0].pairs) +
                             static_cast<double>(halves[1].pairs) -
                             static_cast<double>(content.pairs);
        const double most = std::min(spare, kMaxGrowth * static_cast<double>(content.pairs));
        if (added > most) {
            return visitOverlaps(content.spans, content.cell);
        }
        double left = most - added;
        if (!inCell(halves[0], depth + 1, left) || !inCell(halves[1], depth + 1, left)) {
            return false;
        }
        spare -= most - left;
        return true;
    }

    /// The direction across which parallel segments lie apart.
    Eigen::RowVector2d mostlyAcross(const std::vector<int>& here) const {
        Eigen::RowVector2d doubled(0, 0);
        for (const int i : here) {
            doubled += doubled_[i];
        }
        const double angle = 0.5 * std::atan2(doubled.y(), doubled.x());
        return {-std::sin(angle), std::cos(angle)};
    }

    std::vector<Span> spansAlong(const Content& content) const {
        std::vector<Span> spans(content.parts.size());
        for (std::size_t k = 0; k < spans.size(); ++k) {
            const Segment2& part = content.parts[k];
            const auto [low, high] =
                std::minmax({part.a.dot(content.across), part.b.dot(content.across)});
            spans[k] = {low - margin_, high + margin_, content.here[k]};
        }
        std::sort(spans.begin(), spans.end(), [](const Span& s, const Span& t) {
            return std::tie(s.low, s.segment) < std::tie(t.low, t.segment);
        });
        return spans;
    }

    static std::size_t overlaps(const std::vector<Span>& spans) {
        std::size_t pairs = 0;
        for (std::size_t k = 0; k < spans.size(); ++k) {
            const auto end =
                std::upper_bound(spans.begin() + static_cast<std::ptrdiff_t>(k), spans.end(),
                                 spans[k].high, [](double h, const Span& s) { return h < s.low; });
            pairs += static_cast<std::size_t>(end - spans.begin()) - k - 1;
        }
        return pairs;
    }

    bool visitOverlaps(const std::vector<Span>& spans, const PlaneCell& cell) const {
        for (std::size_t k = 0; k < spans.size(); ++k) {
            for (std::size_t m = k + 1; m < spans.size() && spans[m].low <= spans[k].high; ++m) {
                const auto [first, second] = std::minmax(spans[k].segment, spans[m].segment);
                if (!visit_(first, second, cell)) {
                    return false;
                }
            }
        }
        return true;
    }

    std::vector<Eigen::RowVector2d> doubled_;
    double margin_;
    const PairVisitor& visit_;
};

}  // namespace

bool visitSegmentPairs(const std::vector<Segment2>& segments, double margin,
                       const PairVisitor& visit) {
    if (segments.empty()) {
        return true;
    }
    Eigen::RowVector2d low = segments.front().a;
    Eigen::RowVector2d high = low;
    for (const Segment2& s : segments) {
        low = low.cwiseMin(s.a).cwiseMin(s.b);
        high = high.cwiseMax(s.a).cwiseMax(s.b);
    }
    // So that rounding in clipping loses no meeting place.
    margin = std::max(margin, 4e-12 * (high - low).maxCoeff());
    return Search(segments, margin, visit).run(segments);
}

}  // namespace toile::geometry
