// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <glm/mat4x4.hpp>

namespace toile {

/// Looks straight at the pattern plane, y up. A millimetre has the same size on both axes. Screen
/// places in logical pixels from the upper left corner.
class Camera2D {
public:
    void setViewport(double width, double height);

    void pan(double dx, double dy);
    /// Enlarges (factor > 1) about a pixel, which keeps showing the same point.
    void zoomAt(double x, double y, double factor);
    /// Centres the box and makes it fill the viewport less these margins in pixels.
    struct Margins {
        double sides = 0, top = 0, bottom = 0;
    };
    void frame(const Eigen::AlignedBox2d& box, const Margins& margins);

    Eigen::Vector2d toWorld(double x, double y) const;
    Eigen::Vector2d toScreen(const Eigen::Vector2d& point) const;
    double pixelsPerMillimetre() const { return scale_; }
    /// What is in view, mm.
    Eigen::AlignedBox2d visible() const;
    glm::dmat4 projection() const;

private:
    Eigen::Vector2d centre_ = Eigen::Vector2d::Zero();
    double scale_ = 1;
    double width_ = 1, height_ = 1;
};

}  // namespace toile
