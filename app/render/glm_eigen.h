// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace toile {

/// The one crossing between the core's Eigen and the cameras' GLM.

inline glm::dvec3 toGlm(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}
inline glm::dvec2 toGlm(const Eigen::Vector2d& v) {
    return {v.x(), v.y()};
}
inline Eigen::Vector3d toEigen(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}
inline Eigen::Vector2d toEigen(const glm::dvec2& v) {
    return {v.x, v.y};
}

}  // namespace toile
