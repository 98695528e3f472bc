// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace toile::geometry {

/// Finds coinciding points again: a list of points, and a hash of the cells that contain them. Not
/// thread-safe.
class PointIndex {
public:
    /// @param points     stored as a reference. Callers may append too; their points may not be
    ///                   found
    /// @param tolerance  in the unit of the points; 0: equal bits, with -0 equal to 0
    explicit PointIndex(std::vector<Eigen::Vector3d>& points, double tolerance = 0)
        : points_(points), tolerance_(tolerance) {}
    PointIndex(const PointIndex&) = delete;
    PointIndex& operator=(const PointIndex&) = delete;

    /// The first point within the tolerance, or this one, appended; and whether it is new. Points
    /// that match are not stored, so that no chain of small steps drifts far.
    /// Cost: constant on average.
    std::pair<int, bool> insert(Eigen::Vector3d point);

private:
    using Cell = std::array<std::int64_t, 3>;

    Cell cellOf(const Eigen::Vector3d& point, double moved) const;
    std::size_t bucketOf(const Cell& cell) const;
    int find(const Eigen::Vector3d& point) const;
    void add(int index);

    std::vector<Eigen::Vector3d>& points_;
    double tolerance_;
    std::vector<int> first_;  ///< per bucket: the last point added to it, or -1; a power of two
    std::vector<int> next_;   ///< per point: the one added to its bucket before, or -1
};

}  // namespace toile::geometry
