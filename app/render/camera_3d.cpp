// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/camera_3d.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/render/glm_eigen.h"

namespace toile {

namespace {

/// Vertical opening: narrow enough that a sleeve near the eye does not swell.
constexpr double kFieldOfView = 30.0 * std::numbers::pi / 180.0;
/// Just short of straight down, where the turntable has no up direction.
constexpr double kSteepest = 89.0 * std::numbers::pi / 180.0;
/// Room left around a framed box.
constexpr double kFrameMargin = 1.08;

}  // namespace

void Camera3D::setViewport(double width, double height) {
    width_ = std::max(1.0, width);
    height_ = std::max(1.0, height);
}

void Camera3D::orbit(double dx, double dy) {
    const double radiansPerPixel = std::numbers::pi / height_;
    setDirection(yaw_ - dx * radiansPerPixel, pitch_ + dy * radiansPerPixel);
}

void Camera3D::setDirection(double yaw, double pitch) {
    yaw_ = std::remainder(yaw, 2 * std::numbers::pi);
    pitch_ = std::clamp(pitch, -kSteepest, kSteepest);
}

void Camera3D::pan(double dx, double dy) {
    const double unitsPerPixel = distance_ / pixelsPerUnitAtDepthOne();
    const glm::dmat3 basis = axes();
    target_ += (-dx * basis[0] + dy * basis[1]) * unitsPerPixel;
}

void Camera3D::zoomAt(const Eigen::Vector3d& anchor, double factor) {
    const glm::dvec3 fixed = toGlm(anchor);
    // Eye and target shrink towards the anchor alike, so every direction from the eye is kept.
    target_ = fixed + (target_ - fixed) / factor;
    distance_ /= factor;
}

void Camera3D::frame(std::span<const Eigen::AlignedBox3d> boxes) {
    Eigen::AlignedBox3d all;
    for (const Eigen::AlignedBox3d& box : boxes) {
        all.extend(box);
    }
    if (all.isEmpty()) {
        return;
    }
    target_ = toGlm(Eigen::Vector3d(all.center()));
    double needed = std::numeric_limits<double>::min();
    for (const Eigen::AlignedBox3d& box : boxes) {
        if (!box.isEmpty()) {
            needed = std::max(needed, distanceToFit(box));
        }
    }
    distance_ = needed;
}

double Camera3D::distanceToFit(const Eigen::AlignedBox3d& box) const {
    const glm::dmat3 basis = axes();
    const double tanY = std::tan(kFieldOfView / 2) / kFrameMargin;
    const double tanX = tanY * width_ / height_;
    double needed = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const auto type = static_cast<Eigen::AlignedBox3d::CornerType>(corner);
        const glm::dvec3 offset = toGlm(Eigen::Vector3d(box.corner(type))) - target_;
        const double depth = glm::dot(offset, basis[2]);
        needed = std::max({needed, depth + std::abs(glm::dot(offset, basis[0])) / tanX,
                           depth + std::abs(glm::dot(offset, basis[1])) / tanY});
    }
    return needed;
}

Ray Camera3D::ray(double x, double y) const {
    const glm::dmat3 basis = axes();
    const double scale = 1.0 / pixelsPerUnitAtDepthOne();
    const glm::dvec3 direction =
        (x - width_ / 2) * scale * basis[0] + (height_ / 2 - y) * scale * basis[1] - basis[2];
    return {toEigen(eye()), toEigen(glm::normalize(direction))};
}

Eigen::Vector3d Camera3D::pointAtTargetDepth(double x, double y) const {
    const Ray through = ray(x, y);
    const double cosine = -through.direction.dot(toEigen(axes()[2]));
    return through.origin + through.direction * (distance_ / cosine);
}

Eigen::Vector2d Camera3D::project(const Eigen::Vector3d& point) const {
    const glm::dmat3 basis = axes();
    const glm::dvec3 offset = toGlm(point) - eye();
    const double scale = pixelsPerUnitAtDepthOne() / -glm::dot(offset, basis[2]);
    return {width_ / 2 + glm::dot(offset, basis[0]) * scale,
            height_ / 2 - glm::dot(offset, basis[1]) * scale};
}

glm::dmat4 Camera3D::view() const {
    return glm::lookAt(eye(), target_, axes()[1]);
}

glm::dmat4 Camera3D::projection(const Eigen::AlignedBox3d& box) const {
    double nearest = distance_ * 0.5, farthest = distance_ * 2;
    if (!box.isEmpty()) {
        const double depth = glm::dot(eye() - toGlm(Eigen::Vector3d(box.center())), axes()[2]);
        const double radius = box.diagonal().norm() / 2;
        farthest = std::max(depth + radius, distance_) * 1.01;
        // Never closer than a thousandth of the far plane: depth would run out of digits.
        nearest = std::max(depth - radius * 1.01, farthest * 1e-3);
    }
    return glm::perspective(kFieldOfView, width_ / height_, nearest, farthest);
}

glm::dvec3 Camera3D::eye() const {
    return target_ + axes()[2] * distance_;
}

glm::dmat3 Camera3D::axes() const {
    const glm::dvec3 back(std::cos(pitch_) * std::sin(yaw_), std::sin(pitch_),
                          std::cos(pitch_) * std::cos(yaw_));
    const glm::dvec3 right(std::cos(yaw_), 0.0, -std::sin(yaw_));
    return {right, glm::cross(back, right), back};
}

double Camera3D::pixelsPerUnitAtDepthOne() const {
    return height_ / 2 / std::tan(kFieldOfView / 2);
}

}  // namespace toile
