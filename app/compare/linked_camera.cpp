// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare/linked_camera.h"

namespace toile {

namespace {

/// Room below for the scale bar.
constexpr Camera2D::Margins kMargins{14, 14, 50};

}  // namespace

Camera2D LinkedCamera::seenIn(const QSizeF& size) const {
    Camera2D camera = camera_;
    camera.setViewport(size.width(), size.height());
    return camera;
}

void LinkedCamera::setBox(const Eigen::AlignedBox2d& box) {
    const bool isSame = box.isEmpty() ? box_.isEmpty() : box.isApprox(box_, 1e-9);
    if (!isSame) {
        box_ = box;
        follow();
    }
}

void LinkedCamera::setViewport(const QSizeF& size) {
    camera_.setViewport(size.width(), size.height());
    follow();
}

void LinkedCamera::follow() {
    if (followsAll_) {
        camera_.frame(box_, kMargins);
    }
    emit moved();
}

void LinkedCamera::pan(const QPointF& delta) {
    followsAll_ = false;
    camera_.pan(delta.x(), delta.y());
    emit moved();
}

void LinkedCamera::zoomAt(const QPointF& at, double factor) {
    followsAll_ = false;
    camera_.zoomAt(at.x(), at.y(), factor);
    emit moved();
}

void LinkedCamera::frameAll() {
    followsAll_ = true;
    follow();
}

}  // namespace toile
