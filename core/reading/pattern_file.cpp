// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/pattern_file.h"

#include <algorithm>

namespace toile {

double perimeterOf(const Points2& closed) {
    double length = 0;
    for (Eigen::Index k = 0; k < closed.rows(); ++k) {
        length += (closed.row((k + 1) % closed.rows()) - closed.row(k)).norm();
    }
    return length;
}

double signedAreaOf(const Points2& closed) {
    double doubled = 0;
    for (Eigen::Index k = 1; k + 1 < closed.rows(); ++k) {
        const Eigen::RowVector2d a = closed.row(k) - closed.row(0);
        const Eigen::RowVector2d b = closed.row(k + 1) - closed.row(0);
        doubled += a.x() * b.y() - a.y() * b.x();
    }
    return doubled / 2;
}

bool isInside(const Points2& closed, const Eigen::Vector2d& point) {
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

Points2 antiClockwise(const Points2& closed) {
    return signedAreaOf(closed) < 0 ? Points2(closed.colwise().reverse()) : closed;
}

std::vector<int> sampleOf(const PatternFile& file) {
    const bool hasSample = std::ranges::find(file.sizes, file.sampleSize) != file.sizes.end();
    const std::string size = hasSample            ? file.sampleSize
                             : file.sizes.empty() ? std::string()
                                                  : file.sizes.front();
    std::vector<int> found;
    for (int k = 0; k < static_cast<int>(file.pieces.size()); ++k) {
        const std::string& own = file.pieces[static_cast<std::size_t>(k)].size;
        if (own.empty() || own == size) {
            found.push_back(k);
        }
    }
    return found;
}

}  // namespace toile
