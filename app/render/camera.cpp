// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

#include "app/render/glm_eigen.h"

namespace toile::app {

namespace {

/// Zoom range, from a kilometre to a micrometre in view. Beyond it, float precision fails.
constexpr double kMinScale = 1e-6, kMaxScale = 1e6;

/// Vertical angle: narrow enough to avoid perspective distortion of near sleeves.
constexpr double kFieldOfView = 30.0 * std::numbers::pi / 180.0;
/// Straight down or up; beyond, the garment would be upside down.
constexpr double kSteepest = std::numbers::pi / 2;
/// Start of orthographic rays, mm in front of the target: in front of all cloth.
constexpr double kFarBefore = 2e4;
/// For garments read in a wrong, larger unit: the start as a multiple of the distance.
constexpr double kFarBeforeOfDistance = 100;
/// Limits of the eye's distance from the target when zooming, mm.
constexpr double kNearest = 1e-3, kFarthest = 1e7;
/// Margin factor around a framed box.
constexpr double kFrameMargin = 1.08;

}  // namespace

void Camera2D::setViewport(double width, double height) {
    width_ = std::max(1.0, width);
    height_ = std::max(1.0, height);
}

void Camera2D::pan(double dx, double dy) {
    centre_ += Eigen::Vector2d(-dx, dy) / scale_;
}

void Camera2D::zoomAt(double x, double y, double factor) {
    const Eigen::Vector2d fixed = toWorld(x, y);
    scale_ = std::clamp(scale_ * factor, kMinScale, kMaxScale);
    centre_ += fixed - toWorld(x, y);
}

void Camera2D::frame(const Eigen::AlignedBox2d& box, const Margins& margins) {
    if (box.isEmpty()) {
        return;
    }
    const Eigen::Vector2d size = box.sizes().cwiseMax(1e-9);
    // If the viewport is smaller than its margins, use half of it for the box.
    const double across = std::max(width_ / 2, width_ - 2 * margins.sides);
    const double along = std::max(height_ / 2, height_ - margins.top - margins.bottom);
    scale_ = std::clamp(std::min(across / size.x(), along / size.y()), kMinScale, kMaxScale);
    centre_ = box.center();
    centre_.y() += (margins.top - margins.bottom) / 2 / scale_;
}

Eigen::Vector2d Camera2D::toWorld(double x, double y) const {
    return centre_ + Eigen::Vector2d(x - width_ / 2, height_ / 2 - y) / scale_;
}

Eigen::Vector2d Camera2D::toScreen(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d offset = (point - centre_) * scale_;
    return {width_ / 2 + offset.x(), height_ / 2 - offset.y()};
}

Eigen::AlignedBox2d Camera2D::visible() const {
    const Eigen::Vector2d half = Eigen::Vector2d(width_, height_) / (2 * scale_);
    return {centre_ - half, centre_ + half};
}

glm::dmat4 Camera2D::projection() const {
    const Eigen::AlignedBox2d box = visible();
    return glm::ortho(box.min().x(), box.max().x(), box.min().y(), box.max().y(), -1.0, 1.0);
}

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

void Camera3D::moveTowards(const Camera3D& other, double share) {
    target_ = (1 - share) * target_ + share * other.target_;  // equals the other at 1
    distance_ = std::exp(std::lerp(std::log(distance_), std::log(other.distance_), share));
}

void Camera3D::pan(double dx, double dy) {
    const double unitsPerPixel = distance_ / pixelsPerUnitAtDepthOne();
    const Eigen::Matrix3d basis = axes();
    target_ += (-dx * basis.col(0) + dy * basis.col(1)) * unitsPerPixel;
}

void Camera3D::zoomAt(const Eigen::Vector3d& anchor, double factor) {
    factor = distance_ / std::clamp(distance_ / factor, kNearest, kFarthest);
    // Scaling eye and target towards the anchor keeps every direction from the eye.
    target_ = anchor + (target_ - anchor) / factor;
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
    target_ = all.center();
    double needed = std::numeric_limits<double>::min();
    for (const Eigen::AlignedBox3d& box : boxes) {
        if (!box.isEmpty()) {
            needed = std::max(needed, distanceToFit(box));
        }
    }
    distance_ = needed;
}

double Camera3D::distanceToFit(const Eigen::AlignedBox3d& box) const {
    const Eigen::Matrix3d basis = axes();
    const double tan = std::tan(kFieldOfView / 2);
    const double tanX = tan / kFrameMargin * width_ / height_;
    const double tanY =
        tan * std::max(0.5, std::min(1 / kFrameMargin, 1 - 2 * freeEdges_ / height_));
    double needed = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const auto type = static_cast<Eigen::AlignedBox3d::CornerType>(corner);
        const Eigen::Vector3d offset = basis.transpose() * (box.corner(type) - target_);
        const double depth = orthographic_ ? 0.0 : offset.z();
        needed = std::max(
            {needed, depth + std::abs(offset.x()) / tanX, depth + std::abs(offset.y()) / tanY});
    }
    return needed;
}

double Camera3D::farBefore() const {
    return std::max(kFarBefore, kFarBeforeOfDistance * distance_);
}

Ray Camera3D::ray(double x, double y) const {
    const Eigen::Matrix3d basis = axes();
    const double scale = 1.0 / pixelsPerUnitAtDepthOne();
    const Eigen::Vector2d offMiddle(x - width_ / 2, height_ / 2 - y);
    const Eigen::Vector3d beside = scale * (basis.leftCols<2>() * offMiddle);
    if (orthographic_) {
        return {target_ + distance_ * beside + farBefore() * basis.col(2), -basis.col(2)};
    }
    return {eye(), (beside - basis.col(2)).normalized()};
}

Eigen::Vector3d Camera3D::pointAtTargetDepth(double x, double y) const {
    const Ray through = ray(x, y);
    if (orthographic_) {
        return through.origin + through.direction * farBefore();
    }
    const double cosine = -through.direction.dot(axes().col(2));
    return through.origin + through.direction * (distance_ / cosine);
}

Eigen::Vector2d Camera3D::project(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d offset = axes().transpose() * (point - eye());
    const double depth = orthographic_ ? distance_ : -offset.z();
    const double scale = pixelsPerUnitAtDepthOne() / depth;
    return {width_ / 2 + offset.x() * scale, height_ / 2 - offset.y() * scale};
}

bool Camera3D::isBefore(const Eigen::Vector3d& point) const {
    return orthographic_ || (point - eye()).dot(axes().col(2)) < 0;
}

glm::dmat4 Camera3D::view() const {
    return glm::lookAt(toGlm(eye()), toGlm(target_), toGlm(Eigen::Vector3d(axes().col(1))));
}

Camera3D::DepthRange Camera3D::depthRange(const Eigen::AlignedBox3d& box) const {
    if (box.isEmpty()) {
        return {distance_ * 0.5, distance_ * 2};
    }
    const double depth = (eye() - box.center()).dot(axes().col(2));
    const double radius = box.diagonal().norm() / 2;
    if (orthographic_) {
        return {depth - 1.01 * radius, depth + 1.01 * radius};
    }
    const double farthest = std::max(depth + radius, distance_) * 1.01;
    // Keep the near plane beyond a thousandth of the far plane, or depth loses precision.
    return {std::max(depth - radius * 1.01, farthest * 1e-3), farthest};
}

glm::dmat4 Camera3D::projection(const Eigen::AlignedBox3d& box) const {
    const DepthRange range = depthRange(box);
    if (orthographic_ && !box.isEmpty()) {
        const double halfHeight = distance_ * std::tan(kFieldOfView / 2);
        const double halfWidth = halfHeight * width_ / height_;
        return glm::ortho(-halfWidth, halfWidth, -halfHeight, halfHeight, range.nearest,
                          range.farthest);
    }
    return glm::perspective(kFieldOfView, width_ / height_, range.nearest, range.farthest);
}

double Camera3D::depthShift(const Eigen::AlignedBox3d& box, double share) const {
    const DepthRange range = depthRange(box);
    const double extent = range.farthest - range.nearest;
    if (!(extent > 0)) {
        return 0;
    }
    // In perspective, depth is the inverse of the distance w, and clip space multiplies by w. So a
    // share of the distance is the same number everywhere.
    return orthographic_ && !box.isEmpty() ? 2 * share * distance_ / extent
                                           : 2 * share * range.nearest * range.farthest / extent;
}

Eigen::Vector3d Camera3D::eye() const {
    return target_ + axes().col(2) * distance_;
}

Eigen::Matrix3d Camera3D::axes() const {
    const Eigen::Vector3d back(std::cos(pitch_) * std::sin(yaw_), std::sin(pitch_),
                               std::cos(pitch_) * std::cos(yaw_));
    const Eigen::Vector3d right(std::cos(yaw_), 0.0, -std::sin(yaw_));
    Eigen::Matrix3d basis;
    basis << right, back.cross(right), back;
    return basis;
}

double Camera3D::pixelsPerUnitAtDepthOne() const {
    return height_ / 2 / std::tan(kFieldOfView / 2);
}

}  // namespace toile::app
