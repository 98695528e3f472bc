// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/geometry/triangle_tree.h"
#include "core/prepare/shell_pairs.h"

namespace toile::shell {

/// How the two surfaces of a file are turned to each other.
enum class Facing {
    Apart,    ///< as a solid's: both look away from the cloth
    Towards,  ///< a solid inside out
    Alike,    ///< a copy that looks the same way
};

/// What a ray meets.
struct Meeting {
    int triangle = -1;
    Eigen::Vector3d way = Eigen::Vector3d::Zero();  ///< from the middle of the triangle asked about
};

/// Looks from triangles across the cloth. Keeps a reference. Immutable.
class Rays {
public:
    explicit Rays(const Surface& surface);

    /// The nearest triangle that one meets at right angles to its middle, where it is turned as
    /// asked and not farther; none where something else is nearer.
    Meeting opposite(int triangle, Facing facing, double farthest) const;

    /// All that one meets from its middle in this direction, nearest first, however turned.
    std::vector<Meeting> all(int triangle, const Eigen::Vector3d& direction) const;

private:
    /// @param onMet  (triangle, distance) of one that is not farther; may bring `farthest` nearer
    template <class OnMet>
    void look(int triangle, const Eigen::Vector3d& direction, const double& farthest,
              const OnMet& onMet) const;
    Meeting nearest(int triangle, const Eigen::Vector3d& direction, double farthest) const;

    const Surface& surface_;
    geometry::TriangleTree<3, double> tree_;
    double same_;  ///< nearer than this is no other surface, mm
};

}  // namespace toile::shell
