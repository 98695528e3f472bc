// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <glm/vec3.hpp>

namespace toile::app {

/// The only conversion from the core's Eigen types to the cameras' GLM types.

inline glm::dvec3 toGlm(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

}  // namespace toile::app
