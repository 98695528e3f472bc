// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <glm/vec3.hpp>

namespace toile::app {

/// The one crossing between the core's Eigen and the cameras' GLM.

inline glm::dvec3 toGlm(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

}  // namespace toile::app
