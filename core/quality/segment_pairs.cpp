// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/segment_pairs.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/mesh/segment.h"

namespace toile {
namespace {

/// A cell is quartered where its sweep leaves more than this many pairs for each segment.
constexpr std::size_t kPairsEach = 8;
/// Cells of fewer segments are not worth a division.
constexpr std::size_t kFewSegments = 12;
constexpr int kMaxDepth = 24;
/// Divisions within a cell may add this many times its pairs, all together. Segments that lie on
/// each other are in every part of a cell that they pass, however often it is divided. Where
/// division pays in the end, as in a star, it adds less on the way there.
constexpr double kMostGrowth = 4;

/// The part of a segment in a cell, seen across the sweep.
struct Span {
    double low, high;
    int segment;
};

/// The part of the segment in the cell grown by the margin; false where there is none.
bool clip(const Segment2& s, const PlaneCell& cell, double margin, Segment2& part) {
    const Eigen::RowVector2d along = s.b - s.a;
    const Eigen::RowVector2d low = cell.low.array() - margin, high = cell.high.array() + margin;
    const ShareInBox share = shareInBox(s.a, along, low, high);
    part = {s.a + share.first * along, s.a + share.last * along};
    return share.first <= share.last;
}

class Search {
public:
    Search(const std::vector<Segment2>& segments, double margin, const PairVisitor& visit)
        : segments_(segments), margin_(margin), visit_(visit) {}

    bool run(const PlaneCell& all) const {
        std::vector<int> everyone(segments_.size());
        std::iota(everyone.begin(), everyone.end(), 0);
        const Content content = contentOf(all, everyone);
        double spare = kMostGrowth * static_cast<double>(content.pairs);
        return inCell(content, 0, spare);
    }

private:
    /// What a cell holds.
    struct Content {
        PlaneCell cell;
        std::vector<int> here;  ///< segments
        std::vector<Span> spans;
        std::size_t pairs = 0;  ///< that its sweep leaves
    };

    Content contentOf(const PlaneCell& cell, const std::vector<int>& inside) const {
        Content content{cell, {}, {}, 0};
        std::vector<Segment2> parts;
        for (const int i : inside) {
            Segment2 part;
            if (clip(segments_[i], cell, margin_, part)) {
                parts.push_back(part);
                content.here.push_back(i);
            }
        }
        content.spans = spansAlong(mostlyAcross(parts), parts, content.here);
        content.pairs = overlaps(content.spans);
        return content;
    }

    /// Fewest pairs last. From there they are taken: what their division saves is there for the
    /// one with the most.
    std::vector<Content> quartersOf(const Content& content) const {
        const PlaneCell& cell = content.cell;
        const Eigen::RowVector2d middle = 0.5 * (cell.low + cell.high);
        std::vector<Content> quarters;
        for (const auto& [right, upper] : {std::pair(false, false), std::pair(true, false),
                                           std::pair(false, true), std::pair(true, true)}) {
            PlaneCell quarter = cell;
            (right ? quarter.low : quarter.high).x() = middle.x();
            (upper ? quarter.low : quarter.high).y() = middle.y();
            quarters.push_back(contentOf(quarter, content.here));
        }
        std::ranges::stable_sort(quarters, std::greater(), &Content::pairs);
        return quarters;
    }

    /// @param spare  by how many pairs the divisions around this cell may still add to those there
    ///               were; less what they add in this cell, or more by what they save
    bool inCell(const Content& content, int depth, double& spare) const {
        if (depth == kMaxDepth || content.here.size() < kFewSegments ||
            content.pairs <= kPairsEach * content.here.size()) {
            return visitOverlaps(content.spans, content.cell);
        }
        std::vector<Content> quarters = quartersOf(content);
        double added = -static_cast<double>(content.pairs);
        for (const Content& quarter : quarters) {
            added += static_cast<double>(quarter.pairs);
        }
        const double most = std::min(spare, kMostGrowth * static_cast<double>(content.pairs));
        if (added > most) {
            return visitOverlaps(content.spans, content.cell);
        }
        double left = most - added;
        for (; !quarters.empty(); quarters.pop_back()) {
            if (!inCell(quarters.back(), depth + 1, left)) {
                return false;
            }
        }
        spare -= most - left;
        return true;
    }

    /// The direction across which parallel segments lie apart: angles are doubled, so that to and
    /// fro count alike.
    static Eigen::RowVector2d mostlyAcross(const std::vector<Segment2>& parts) {
        Eigen::RowVector2d doubled(0, 0);
        for (const Segment2& part : parts) {
            const Eigen::RowVector2d d = part.b - part.a;
            const double length = d.norm();
            if (length > 0) {
                doubled +=
                    Eigen::RowVector2d(d.x() * d.x() - d.y() * d.y(), 2 * d.x() * d.y()) / length;
            }
        }
        const double angle = 0.5 * std::atan2(doubled.y(), doubled.x());
        return {-std::sin(angle), std::cos(angle)};
    }

    std::vector<Span> spansAlong(const Eigen::RowVector2d& axis, const std::vector<Segment2>& parts,
                                 const std::vector<int>& here) const {
        std::vector<Span> spans(parts.size());
        for (std::size_t k = 0; k < parts.size(); ++k) {
            const auto [low, high] = std::minmax({parts[k].a.dot(axis), parts[k].b.dot(axis)});
            spans[k] = {low - margin_, high + margin_, here[k]};
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

    const std::vector<Segment2>& segments_;
    double margin_;
    const PairVisitor& visit_;
};

}  // namespace

bool visitSegmentPairs(const std::vector<Segment2>& segments, double margin,
                       const PairVisitor& visit) {
    if (segments.empty()) {
        return true;
    }
    PlaneCell all{segments.front().a, segments.front().a};
    for (const Segment2& s : segments) {
        all.low = all.low.cwiseMin(s.a).cwiseMin(s.b);
        all.high = all.high.cwiseMax(s.a).cwiseMax(s.b);
    }
    // No place of a meeting lies on the outermost sides, and none is lost to a rounded clipping.
    const double extent = (all.high - all.low).maxCoeff();
    margin = std::max(margin, 4e-12 * extent);
    all.low.array() -= 2 * margin;
    all.high.array() += 2 * margin;
    return Search(segments, margin, visit).run(all);
}

}  // namespace toile
