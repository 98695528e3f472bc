// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace toile {

/// A seam of the garment's own division that the user has taken out: the cloth on its two sides
/// becomes one. Known by points along it, so that it outlives a change of the mesh.
struct UserJoin {
    std::string name;
    /// mm, from one end of the seam to the other, two or more. A seam that is a closed line repeats
    /// its first point at the end and has points enough between to tell the way round.
    std::vector<Eigen::Vector3d> points;

    bool operator==(const UserJoin&) const = default;
};

}  // namespace toile
