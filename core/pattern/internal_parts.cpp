// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing of internal lines: whole, and on a half pattern.

#include <utility>

#include "core/geometry/segment.h"
#include "core/pattern/darts.h"
#include "core/pattern/internal_lines.h"

namespace toile {

std::vector<PieceInternal> leftPart(const PieceInternal& internal, const Chord& chord) {
    const Eigen::RowVector2d from = chord.from.transpose();
    const Eigen::RowVector2d along = (chord.to - chord.from).transpose().normalized();
    constexpr double kOnChord = 1e-6;  // mm
    const Points2& points = internal.points;
    const auto side = [&](Eigen::Index k) {
        return geometry::cross(along, points.row(k) - from) + kOnChord;
    };
    const Eigen::Index n = points.rows();
    PieceInternal part{.line = internal.line, .name = internal.name};
    if (n == 0 || (n == 1 && side(0) < 0)) {
        return {};
    }
    bool isAllLeft = true;
    Eigen::Index start = 0;  // of a closed line: where it crosses to the left
    for (Eigen::Index k = 0; k < n; ++k) {
        isAllLeft = isAllLeft && side(k) >= 0;
        if (internal.closed && side(k) < 0) {
            start = k;
        }
    }
    if (isAllLeft) {
        part.points = points;
        part.closed = internal.closed;
        part.length = internal.length;
        return {part};
    }
    std::vector<PieceInternal> parts;
    std::vector<Eigen::RowVector2d> open;
    const auto finish = [&] {
        if (open.size() > 1) {
            part.points.resize(static_cast<Eigen::Index>(open.size()), 2);
            part.length = 0;
            for (std::size_t k = 0; k < open.size(); ++k) {
                part.points.row(static_cast<Eigen::Index>(k)) = open[k];
                part.length += k > 0 ? (open[k] - open[k - 1]).norm() : 0;
            }
            parts.push_back(part);
        }
        open.clear();
    };
    const Eigen::Index steps = internal.closed ? n : n - 1;
    for (Eigen::Index k = 0; k < steps; ++k) {
        const Eigen::Index here = (start + k) % n, there = (start + k + 1) % n;
        const double a = side(here), b = side(there);
        const auto crossing = [&]() -> Eigen::RowVector2d {
            return points.row(here) + a / (a - b) * (points.row(there) - points.row(here));
        };
        if (a >= 0 && open.empty()) {
            open.emplace_back(points.row(here));
        }
        if (a < 0 && b >= 0) {
            open.emplace_back(crossing());
        }
        if (a >= 0 && b < 0) {
            open.push_back(crossing());
            finish();
        } else if (b >= 0) {
            open.emplace_back(points.row(there));
        }
    }
    finish();
    return parts;
}

std::vector<Points2> leftParts(const std::vector<Points2>& lines, const Chord& chord) {
    std::vector<Points2> parts;
    for (const Points2& line : lines) {
        for (PieceInternal& part : leftPart({.points = line}, chord)) {
            parts.push_back(std::move(part.points));
        }
    }
    return parts;
}

std::vector<Points2> drawnLines(const PieceInternal& internal) {
    const Eigen::Index n = internal.points.rows();
    if (n == 0) {
        return {};
    }
    if (n > 1) {
        Points2 line(n + (internal.closed ? 1 : 0), 2);
        line << internal.points, internal.points.topRows(line.rows() - n);
        return {line};
    }
    const Eigen::RowVector2d at = internal.points.row(0);
    std::vector<Points2> lines{drillCircle(at.transpose())};
    for (int axis = 0; axis < 2; ++axis) {
        const Eigen::RowVector2d half = kDrillRadius * Eigen::RowVector2d::Unit(axis);
        Points2& stroke = lines.emplace_back(2, 2);
        stroke << at - half, at + half;
    }
    return lines;
}

}  // namespace toile
