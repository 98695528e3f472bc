// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/capped_outline.h"

#include <algorithm>
#include <cstddef>

#include "core/geometry/line.h"

namespace toile {
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

}  // namespace toile
