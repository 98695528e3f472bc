// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "core/geometry/triangle_tree.h"
#include "core/prepare/shell_pairs.h"

namespace toile::shell {

/// The relative orientation of the two surfaces of a file.
enum class Facing {
    Apart,    ///< like a solid's: both face away from the cloth
    Towards,  ///< a solid inside out
    Alike,    ///< a copy with the same orientation
};

/// The hit of a ray.
struct Meeting {
    int triangle = -1;
    Eigen::Vector3d way = Eigen::Vector3d::Zero();  ///< from the centroid of the queried triangle
};

/// Casts rays from triangles across the cloth. Keeps a reference. Immutable.
class Rays {
public:
    explicit Rays(const Surface& surface);

    /// The nearest triangle along the normal at the centroid, if it has the given facing and is
    /// within the distance; nothing if another one is nearer.
    Meeting opposite(int triangle, Facing facing, double farthest) const;

    /// All hits from the centroid in this direction, nearest first, at any angle.
    /// @param visits  triangles that may still be tested, by all rays; reduced. Each ray may test
    ///                a few, which may miss hits.
    std::vector<Meeting> all(int triangle, const Eigen::Vector3d& direction, long& visits) const;
    std::vector<Meeting> all(int triangle, const Eigen::Vector3d& direction) const {
        long unlimited = std::numeric_limits<long>::max();
        return all(triangle, direction, unlimited);
    }

private:
    /// @param onMet  called with (triangle, distance) within `farthest`, which it may reduce
    /// @return the number of triangles tested
    template <class OnMet>
    long look(int triangle, const Eigen::Vector3d& direction, const double& farthest,
              long maxVisits, const OnMet& onMet) const;
    Meeting nearest(int triangle, const Eigen::Vector3d& direction, double farthest) const;

    const Surface& surface_;
    geometry::TriangleTree<3, double> tree_;
    double same_;  ///< mm; closer hits are the same surface
};

}  // namespace toile::shell
