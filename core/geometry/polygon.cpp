// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/polygon.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/geometry/segment.h"

namespace toile::geometry {

double perimeterOf(const Polygon& closed) {
    double length = 0;
    for (Eigen::Index k = 0; k < closed.rows(); ++k) {
        length += (closed.row((k + 1) % closed.rows()) - closed.row(k)).norm();
    }
    return length;
}

double signedAreaOf(const Polygon& closed) {
    double doubled = 0;
    for (Eigen::Index k = 1; k + 1 < closed.rows(); ++k) {
        const Eigen::RowVector2d a = closed.row(k) - closed.row(0);
        const Eigen::RowVector2d b = closed.row(k + 1) - closed.row(0);
        doubled += cross(a, b);
    }
    return doubled / 2;
}

bool isInside(const Polygon& closed, const Eigen::Vector2d& point) {
    bool inside = false;
    for (Eigen::Index k = 0, before = closed.rows() - 1; k < closed.rows(); before = k++) {
        const double y = closed(k, 1), other = closed(before, 1);
        if ((y > point.y()) != (other > point.y()) &&
            point.x() <
                closed(k, 0) + (closed(before, 0) - closed(k, 0)) * (point.y() - y) / (other - y)) {
            inside = !inside;
        }
    }
    return inside;
}

Eigen::AlignedBox2d boxAround(const Polygon& points) {
    Eigen::AlignedBox2d box;
    for (const auto& row : points.rowwise()) {
        box.extend(row.transpose());
    }
    return box;
}

// Andrew's monotone chain: the lower half from left to right, then the upper half back.
Polygon convexHull(const Polygon& points) {
    std::vector<Eigen::RowVector2d> sorted, hull;
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        sorted.emplace_back(points.row(k));
    }
    std::ranges::sort(sorted, {}, [](const auto& p) { return std::pair(p.x(), p.y()); });
    for (int half = 0; half < 2; ++half) {
        const std::size_t first = hull.size();
        for (const Eigen::RowVector2d& point : sorted) {
            while (hull.size() > first + 1 &&
                   cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0) {
                hull.pop_back();
            }
            hull.push_back(point);
        }
        if (!hull.empty()) {
            hull.pop_back();  // the other half starts with it
        }
        std::ranges::reverse(sorted);
    }
    Polygon corners(static_cast<Eigen::Index>(hull.size()), 2);
    for (std::size_t k = 0; k < hull.size(); ++k) {
        corners.row(static_cast<Eigen::Index>(k)) = hull[k];
    }
    return corners;
}

Polygon antiClockwise(const Polygon& closed) {
    return signedAreaOf(closed) < 0 ? Polygon(closed.colwise().reverse()) : closed;
}

}  // namespace toile::geometry
