// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace toile::geometry {

/// Finds points again that lie on each other: a list of points, and a hash of the cells they stand
/// in. Not thread-safe.
class PointIndex {
public:
    /// @param points     to which new ones are appended, by this class or by others; it is kept by
    ///                   reference. Those of others are not found for sure
    /// @param tolerance  in the unit of the points; 0: the same bits, with -0 taken as 0
    explicit PointIndex(std::vector<Eigen::Vector3d>& points, double tolerance = 0)
        : points_(points), tolerance_(tolerance) {}
    PointIndex(const PointIndex&) = delete;
    PointIndex& operator=(const PointIndex&) = delete;

    /// The first point within the tolerance, or this one at the list's end; whether it is new.
    /// Points that were found are not kept, so that no chain of small steps leads far.
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
