// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layout/marker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/pattern/half_pattern.h"

namespace toile {
namespace {

using Box = Eigen::AlignedBox2d;

constexpr double kRounding = 1e-12;
constexpr double kLargestGap = 20;    // mm
constexpr double kRelativeGap = 0.1;  // of the largest side of a piece
constexpr double kBestAspect = 1.25;  // width over height: between a square and 3 to 2
constexpr int kWidthTrials = 32;
constexpr double kNarrowestTrial = 0.75;  // of the width of a packing without waste
constexpr double kTrialStep = 1.0 / 16;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// A box to place, and the width of its cloth.
struct BoxOnCloth {
    Box box;
    double clothWidth;
};

/// A row has pieces first .. last-1 and is as high as the highest of them.
struct Row {
    std::size_t first = 0, last = 0;
    double width = 0, height = 0;
    double clothWidth = 0;  ///< of the narrowest cloth in the row
};

/// Fills rows from left to right; a row ends if the next piece would exceed `limit` or the width of
/// a cloth in the row.
std::vector<Row> fillRows(const std::vector<BoxOnCloth>& boxes, double gap, double limit) {
    std::vector<Row> rows;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const auto& [box, clothWidth] = boxes[i];
        const Eigen::Vector2d size = box.sizes();
        const double narrowest =
            rows.empty() ? clothWidth : std::min(rows.back().clothWidth, clothWidth);
        if (rows.empty() || rows.back().width + gap + size.x() > std::min(limit, narrowest)) {
            rows.push_back({i, i + 1, size.x(), size.y(), clothWidth});
            continue;
        }
        Row& row = rows.back();
        row.last = i + 1;
        row.width += gap + size.x();
        row.height = std::max(row.height, size.y());
        row.clothWidth = narrowest;
    }
    return rows;
}

Eigen::Vector2d extent(const std::vector<Row>& rows, double gap) {
    Eigen::Vector2d size(0, 0);
    for (const Row& row : rows) {
        size.x() = std::max(size.x(), row.width);
        size.y() += row.height + (&row == rows.data() ? 0.0 : gap);
    }
    return size;
}

/// Cost of a sheet: distance of its aspect ratio from the best, equal for too wide and too high,
/// times the square of its area. A row with a single leftover piece costs area; the square keeps a
/// sheet from growing wider at the same height only for its proportions.
double awkwardness(const Eigen::Vector2d& size) {
    if (!(size.x() > 0) || !(size.y() > 0)) {
        return HUGE_VAL;
    }
    const double ratio = size.x() / (size.y() * kBestAspect);
    return std::max(ratio, 1 / ratio) * size.prod() * size.prod();
}

/// Tries row widths around that of a packing without waste and keeps the first of the best.
std::vector<Row> chooseRows(const std::vector<BoxOnCloth>& boxes, double gap) {
    double area = 0, widest = 0;
    for (const auto& [box, clothWidth] : boxes) {
        area += (box.sizes().x() + gap) * (box.sizes().y() + gap);
        widest = std::max(widest, box.sizes().x());
    }
    const double ideal = std::sqrt(area * kBestAspect);
    std::vector<Row> best;
    double least = 0;
    for (int trial = 0; trial < kWidthTrials; ++trial) {
        const double limit = std::max(widest, ideal * (kNarrowestTrial + kTrialStep * trial));
        std::vector<Row> rows = fillRows(boxes, gap, limit);
        const double cost = awkwardness(extent(rows, gap));
        if (trial == 0 || cost < least) {
            best = std::move(rows);
            least = cost;
        }
    }
    return best;
}

Box boxOf(const PatternPiece& piece, const Placement& placement) {
    Box box = outlineBox(turnedLine(edgeOf(piece), placement), {});
    return box.isEmpty() ? box : box.translate(placement.offset);
}

double largestSide(std::span<const Box> boxes) {
    double largest = 0;
    for (const Box& box : boxes) {
        largest = std::max(largest, box.isEmpty() ? 0 : box.sizes().maxCoeff());
    }
    return largest;
}

/// Puts pieces without a placement in rows beside the others.
void placeTheRest(const Pattern& pattern, const std::vector<std::size_t>& rest, const Box& placed,
                  const Fabric& own, Marker& marker) {
    std::vector<Box> boxes;
    std::vector<double> clothWidths;
    for (const std::size_t copy : rest) {
        const PatternPiece& piece =
            pattern.pieces[static_cast<std::size_t>(marker.copies[copy].piece)];
        boxes.push_back(outlineBox(edgeOf(piece), {}));
        clothWidths.push_back(fabricOf(piece.material, pattern.materials, own).width);
    }
    const Rows rows = layOutInRows(boxes, clothWidths);
    marker.width = rows.width;
    marker.height = rows.height;
    Eigen::Vector2d corner(0, 0);
    if (!placed.isEmpty()) {
        const double largest = std::max({rows.width, rows.height, placed.sizes().maxCoeff()});
        corner = {placed.max().x() + gapBetweenPieces(largest), placed.min().y()};
    }
    for (std::size_t i = 0; i < rest.size(); ++i) {
        marker.copies[rest[i]].placement.offset = corner + rows.offset[i];
    }
}

}  // namespace

double gapBetweenPieces(double largestSide) {
    return std::min(kLargestGap, kRelativeGap * largestSide);
}

Rows layOutInRows(std::span<const Box> boxes, std::span<const double> clothWidths) {
    std::vector<BoxOnCloth> filled;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (!boxes[i].isEmpty()) {
            filled.push_back({boxes[i], clothWidths.empty() ? kNoLimit : clothWidths[i]});
        }
    }
    const double gap = gapBetweenPieces(largestSide(boxes));
    const std::vector<Row> chosen = chooseRows(filled, gap);
    const Eigen::Vector2d size = extent(chosen, gap);
    std::vector<Eigen::Vector2d> offset;
    double top = size.y();  // the first row is at the top, as in writing
    for (const Row& row : chosen) {
        Eigen::Vector2d place(0, std::max(0.0, top - row.height));
        for (std::size_t i = row.first; i < row.last; ++i) {
            offset.emplace_back(place - filled[i].box.min());
            place.x() += filled[i].box.sizes().x() + gap;
        }
        top -= row.height + gap;
    }
    Rows rows{{}, size.x(), size.y()};
    std::size_t next = 0;
    for (const Box& box : boxes) {
        rows.offset.push_back(box.isEmpty() ? Eigen::Vector2d(0, 0) : offset[next++]);
    }
    return rows;
}

Rows layOutInRows(const Pattern& pattern) {
    std::vector<Box> boxes;
    for (const PatternPiece& piece : pattern.pieces) {
        boxes.push_back(outlineBox(edgeOf(piece), {}));
    }
    return layOutInRows(boxes);
}

Marker placeCopies(const Pattern& pattern, const std::vector<std::optional<Placement>>& placements,
                   const Fabric& own) {
    Marker marker;
    std::vector<std::size_t> rest;
    Box placed;
    for (std::size_t i = 0; i < pattern.pieces.size(); ++i) {
        const PatternPiece& piece = pattern.pieces[i];
        if (piece.outline.rows() == 0) {
            continue;
        }
        const bool hasPlace = i < placements.size() && placements[i];
        if (hasPlace) {
            placed.extend(boxOf(piece, *placements[i]));
        } else {
            rest.push_back(marker.copies.size());
        }
        marker.copies.push_back({static_cast<int>(i), hasPlace ? *placements[i] : Placement{}});
    }
    if (!rest.empty()) {
        placeTheRest(pattern, rest, placed, own, marker);
    }
    if (placed.isEmpty()) {
        return marker;  // rows begin at the corner
    }
    Box all = placed;
    for (const std::size_t copy : rest) {
        const PlacedCopy& lies = marker.copies[copy];
        all.extend(boxOf(pattern.pieces[static_cast<std::size_t>(lies.piece)], lies.placement));
    }
    marker.width = all.sizes().x();
    marker.height = all.sizes().y();
    // If the corner is already at the origin, except for rounding, keep every digit.
    if (all.min().cwiseAbs().maxCoeff() > kRounding * all.sizes().maxCoeff()) {
        for (PlacedCopy& lies : marker.copies) {
            lies.placement.offset -= all.min();
        }
    }
    return marker;
}

LaidOutPattern cutAndPlace(Pattern whole, const std::vector<std::optional<Placement>>& placements,
                           const Fabric& own) {
    LaidOutPattern laid;
    laid.whole = placeCopies(whole, placements, own);
    laid.wholePattern = whole;
    laid.pattern = asCut(std::move(whole));
    laid.marker = placeCopies(laid.pattern, placements, own);
    return laid;
}

}  // namespace toile
