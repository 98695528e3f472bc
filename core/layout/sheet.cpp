// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layout/sheet.h"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

constexpr double kLargestGap = 20;    // mm
constexpr double kRelativeGap = 0.1;  // of the largest side of a piece
constexpr double kBestAspect = 1.25;  // width over height: between a square and 3 to 2
constexpr int kWidthTrials = 32;
constexpr double kNarrowestTrial = 0.75;  // of the width a packing without waste would have
constexpr double kTrialStep = 1.0 / 16;

struct Rectangle {
    Eigen::Vector2d corner = Eigen::Vector2d::Zero();  // lower left
    Eigen::Vector2d size = Eigen::Vector2d::Zero();
};

Rectangle boundingBox(const Points2& outline) {
    Rectangle box;
    if (outline.rows() > 0) {
        box.corner = outline.colwise().minCoeff().transpose();
        box.size = outline.colwise().maxCoeff().transpose() - box.corner;
    }
    return box;
}

/// A row takes pieces first .. last-1 and is as high as the highest of them.
struct Row {
    std::size_t first = 0, last = 0;
    double width = 0, height = 0;
};

/// Fills rows from left to right; a row ends where the next piece would pass `limit`.
std::vector<Row> fillRows(const std::vector<Rectangle>& boxes, double gap, double limit) {
    std::vector<Row> rows;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Eigen::Vector2d& size = boxes[i].size;
        if (rows.empty() || rows.back().width + gap + size.x() > limit) {
            rows.push_back({i, i + 1, size.x(), size.y()});
            continue;
        }
        Row& row = rows.back();
        row.last = i + 1;
        row.width += gap + size.x();
        row.height = std::max(row.height, size.y());
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

/// What a person sees of a sheet: how far its aspect is from the best, alike for too wide and too
/// high, times the square of the area it takes up. A row with one lost piece costs area; the square
/// keeps a sheet from growing wider at the same height only to look better proportioned.
double awkwardness(const Eigen::Vector2d& size) {
    if (!(size.x() > 0) || !(size.y() > 0)) {
        return HUGE_VAL;
    }
    const double ratio = size.x() / (size.y() * kBestAspect);
    return std::max(ratio, 1 / ratio) * size.prod() * size.prod();
}

/// Tries row widths around that of a packing without waste and keeps the first of the best.
std::vector<Row> chooseRows(const std::vector<Rectangle>& boxes, double gap) {
    double area = 0, widest = 0;
    for (const Rectangle& box : boxes) {
        area += (box.size.x() + gap) * (box.size.y() + gap);
        widest = std::max(widest, box.size.x());
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

Sheet layOut(const std::vector<Rectangle>& boxes) {
    double largest = 0;
    for (const Rectangle& box : boxes) {
        largest = std::max(largest, box.size.maxCoeff());
    }
    const double gap = gapBetweenPieces(largest);
    const std::vector<Row> rows = chooseRows(boxes, gap);
    const Eigen::Vector2d size = extent(rows, gap);

    Sheet sheet;
    sheet.width = size.x();
    sheet.height = size.y();
    sheet.offset.resize(boxes.size(), Eigen::Vector2d::Zero());
    double top = size.y();  // the first row is the upper one, as in writing
    for (const Row& row : rows) {
        Eigen::Vector2d place(0, std::max(0.0, top - row.height));
        for (std::size_t i = row.first; i < row.last; ++i) {
            sheet.offset[i] = place - boxes[i].corner;
            place.x() += boxes[i].size.x() + gap;
        }
        top -= row.height + gap;
    }
    return sheet;
}

}  // namespace

double gapBetweenPieces(double largestSide) {
    return std::min(kLargestGap, kRelativeGap * largestSide);
}

Sheet layOutInRows(const Pattern& pattern) {
    std::vector<Rectangle> boxes;
    boxes.reserve(pattern.pieces.size());
    for (const PatternPiece& piece : pattern.pieces) {
        boxes.push_back(boundingBox(piece.outline));
    }
    return layOut(boxes);
}

Sheet layOutInRows(std::span<const Eigen::AlignedBox2d> placed) {
    std::vector<Rectangle> boxes;
    boxes.reserve(placed.size());
    for (const Eigen::AlignedBox2d& box : placed) {
        boxes.push_back(box.isEmpty() ? Rectangle{} : Rectangle{box.min(), box.sizes()});
    }
    return layOut(boxes);
}

}  // namespace toile
