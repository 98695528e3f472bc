// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/camera_2d.h"

#include <algorithm>

#include <glm/ext/matrix_clip_space.hpp>

namespace toile {

namespace {

/// From a kilometre to a micrometre in view: beyond, floats and people lose their way.
constexpr double kLeastScale = 1e-6, kLargestScale = 1e6;

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
    scale_ = std::clamp(scale_ * factor, kLeastScale, kLargestScale);
    centre_ += fixed - toWorld(x, y);
}

void Camera2D::frame(const Eigen::AlignedBox2d& box, const Margins& margins) {
    if (box.isEmpty()) {
        return;
    }
    const Eigen::Vector2d size = box.sizes().cwiseMax(1e-9);
    // A viewport smaller than its margins gives half of itself to the box all the same.
    const double across = std::max(width_ / 2, width_ - 2 * margins.sides);
    const double along = std::max(height_ / 2, height_ - margins.top - margins.bottom);
    scale_ = std::clamp(std::min(across / size.x(), along / size.y()), kLeastScale, kLargestScale);
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

}  // namespace toile
