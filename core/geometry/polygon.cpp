// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/polygon.h"

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

Polygon antiClockwise(const Polygon& closed) {
    return signedAreaOf(closed) < 0 ? Polygon(closed.colwise().reverse()) : closed;
}

}  // namespace toile::geometry
