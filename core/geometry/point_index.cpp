// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/point_index.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace toile::geometry {
namespace {

constexpr std::size_t kFirstBuckets = 1024;
/// Cells beyond this share one index, which only costs time.
constexpr double kFarthestCell = 1e18;

}  // namespace

std::pair<int, bool> PointIndex::insert(Eigen::Vector3d point) {
    point.array() += 0.0;  // -0 + 0 is 0, all else stays
    if (const int known = find(point); known >= 0) {
        return {known, false};
    }
    points_.push_back(point);
    next_.resize(points_.size(), -1);
    if (points_.size() <= first_.size()) {
        add(static_cast<int>(points_.size()) - 1);
        return {static_cast<int>(points_.size()) - 1, true};
    }
    first_.assign(std::bit_ceil(std::max(kFirstBuckets, 2 * points_.size())), -1);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        add(static_cast<int>(i));
    }
    return {static_cast<int>(points_.size()) - 1, true};
}

/// For tolerance 0 the bits of the coordinates, else cubes of twice the tolerance, counted from the
/// first point so that indices stay small far from the origin.
/// @param moved  by so much along each axis
PointIndex::Cell PointIndex::cellOf(const Eigen::Vector3d& point, double moved) const {
    Cell cell;
    for (int k = 0; k < 3; ++k) {
        if (tolerance_ > 0) {
            const double at =
                std::floor((point[k] - points_.front()[k] + moved) / (2 * tolerance_));
            cell[k] = static_cast<std::int64_t>(at > -kFarthestCell ? std::min(at, kFarthestCell)
                                                                    : -kFarthestCell);
        } else {
            cell[k] = std::bit_cast<std::int64_t>(point[k]);
        }
    }
    return cell;
}

std::size_t PointIndex::bucketOf(const Cell& cell) const {
    std::uint64_t h = 0;
    for (const std::int64_t c : cell) {
        h = (h ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15u;
        h ^= h >> 32;  // the well mixed bits are the high ones, buckets take the low
    }
    return h & (first_.size() - 1);
}

int PointIndex::find(const Eigen::Vector3d& point) const {
    if (first_.empty()) {
        return -1;
    }
    int least = -1;
    const Cell low = cellOf(point, -tolerance_);
    const Cell high = cellOf(point, tolerance_);  // at most one further along each axis
    const auto isSame = [&](const Eigen::Vector3d& other) {
        return tolerance_ > 0 ? (other - point).norm() <= tolerance_ : cellOf(other, 0) == low;
    };
    for (auto x = low[0]; x <= high[0]; ++x) {
        for (auto y = low[1]; y <= high[1]; ++y) {
            for (auto z = low[2]; z <= high[2]; ++z) {
                for (int i = first_[bucketOf({x, y, z})]; i >= 0; i = next_[i]) {
                    if ((least < 0 || i < least) && isSame(points_[i])) {
                        least = i;
                    }
                }
            }
        }
    }
    return least;
}

void PointIndex::add(int index) {
    int& first = first_[bucketOf(cellOf(points_[index], 0))];
    next_[index] = first;
    first = index;
}

}  // namespace toile::geometry
