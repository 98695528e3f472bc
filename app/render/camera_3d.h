// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace toile {

/// A half-line from the eye, in the scene's coordinates.
struct Ray {
    Eigen::Vector3d origin;
    Eigen::Vector3d direction;  ///< unit
};

/// A turntable around a target, y up: the garment stands upright however it is turned. Lengths in
/// mm, screen places in logical pixels from the upper left corner.
class Camera3D {
public:
    void setViewport(double width, double height);

    /// Turns by a drag of so many pixels; half a viewport height is a quarter turn.
    void orbit(double dx, double dy);
    /// Moves so that what lies at the target's depth follows the pointer.
    void pan(double dx, double dy);
    /// Brings the eye nearer to `anchor` (factor > 1) without moving it on the screen.
    void zoomAt(const Eigen::Vector3d& anchor, double factor);
    /// Keeps the direction and moves back until all boxes just fit, with a margin. Several small
    /// boxes hug a garment closer than one around all; empty ones are passed by.
    void frame(std::span<const Eigen::AlignedBox3d> boxes);
    /// Direction of view in radians: yaw around y from the front, pitch upwards.
    void setDirection(double yaw, double pitch);

    Ray ray(double x, double y) const;
    /// Point on the ray through a pixel at the target's depth.
    Eigen::Vector3d pointAtTargetDepth(double x, double y) const;
    /// Screen place of a point, in pixels; meaningless behind the eye.
    Eigen::Vector2d project(const Eigen::Vector3d& point) const;

    glm::dmat4 view() const;
    /// @param box what is to be seen: near and far are set around it
    glm::dmat4 projection(const Eigen::AlignedBox3d& box) const;
    glm::dvec3 eye() const;
    double distance() const { return distance_; }

private:
    /// Distance from the target at which the box fits, as seen from the present direction.
    double distanceToFit(const Eigen::AlignedBox3d& box) const;
    glm::dmat3 axes() const;  ///< columns: right, up, towards the eye
    double pixelsPerUnitAtDepthOne() const;

    glm::dvec3 target_{0.0};
    double distance_ = 1000;
    double yaw_ = 0.45, pitch_ = 0.12;
    double width_ = 1, height_ = 1;
};

}  // namespace toile
