// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/outline_corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace toile {

std::vector<int> outlineCorners(const Piece& piece) {
    const auto& [V, F] = piece.mesh;
    std::vector<int> placeOf(static_cast<std::size_t>(V.rows()), -1);
    for (std::size_t k = 0; k < piece.boundary.size(); ++k) {
        placeOf[static_cast<std::size_t>(piece.boundary[k])] = static_cast<int>(k);
    }
    // The cloth's angle at the vertex: how far it is from straight is how far the outline turns.
    std::vector<double> angles(piece.boundary.size(), 0.0);
    for (Eigen::Index f = 0; f < F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const int place = placeOf[static_cast<std::size_t>(F(f, k))];
            if (place < 0) {
                continue;
            }
            const Eigen::Vector3d a = V.row(F(f, k)), b = V.row(F(f, (k + 1) % 3)),
                                  c = V.row(F(f, (k + 2) % 3));
            angles[static_cast<std::size_t>(place)] +=
                std::atan2((b - a).cross(c - a).norm(), (b - a).dot(c - a));
        }
    }
    std::vector<int> corners;
    for (std::size_t k = 0; k < angles.size(); ++k) {
        if (std::abs(std::numbers::pi - angles[k]) > kCornerTurn) {
            corners.push_back(static_cast<int>(k));
        }
    }
    return corners;
}

OutlineRun runBetweenCorners(const std::vector<int>& corners, int size, int edge) {
    if (corners.size() < 2) {
        return {corners.empty() ? 0 : corners.front(), size};
    }
    const auto next = std::ranges::upper_bound(corners, edge);
    const int end = next == corners.end() ? corners.front() + size : *next;
    const int begin = next == corners.begin() ? corners.back() - size : *std::prev(next);
    return {(begin + size) % size, end - begin};
}

}  // namespace toile
