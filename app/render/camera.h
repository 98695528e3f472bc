// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <glm/mat4x4.hpp>

namespace toile::app {

/// Looks straight at the pattern plane, y up. Scales both axes alike. Screen places are logical
/// pixels from the upper left corner.
class Camera2D {
public:
    void setViewport(double width, double height);

    void pan(double dx, double dy);
    /// Enlarges (factor > 1) around a pixel, which keeps showing the same point.
    void zoomAt(double x, double y, double factor);
    /// Centres the box and fits it into the viewport inside these margins, in pixels.
    struct Margins {
        double sides = 0, top = 0, bottom = 0;
    };
    void frame(const Eigen::AlignedBox2d& box, const Margins& margins);

    Eigen::Vector2d toWorld(double x, double y) const;
    Eigen::Vector2d toScreen(const Eigen::Vector2d& point) const;
    double pixelsPerMillimetre() const { return scale_; }
    /// The visible area, mm.
    Eigen::AlignedBox2d visible() const;
    glm::dmat4 projection() const;

private:
    Eigen::Vector2d centre_ = Eigen::Vector2d::Zero();
    double scale_ = 1;
    double width_ = 1, height_ = 1;
};

/// A half-line from the eye in scene coordinates.
struct Ray {
    Eigen::Vector3d origin;
    Eigen::Vector3d direction;  ///< unit
};

/// A turntable camera around a target: y stays up. Lengths are in mm, screen places in logical
/// pixels from the upper left corner.
class Camera3D {
public:
    void setViewport(double width, double height);
    /// Height of the slider at the bottom of the garment view, logical pixels.
    static constexpr double kSliderRoom = 46;
    /// Sets the margin of framing at the upper and lower edge, logical pixels.
    void setFreeEdges(double pixels) { freeEdges_ = pixels; }

    /// Turns by a drag in pixels; half a viewport height is a quarter turn.
    void orbit(double dx, double dy);
    /// Moves so that points at the target's depth follow the pointer.
    void pan(double dx, double dy);
    /// Brings the eye closer to `anchor` (factor > 1), which stays put on the screen.
    void zoomAt(const Eigen::Vector3d& anchor, double factor);
    /// Keeps the direction and moves back until all boxes fit, with a margin. Several small boxes
    /// fit a garment more tightly than one around all. Ignores empty boxes.
    void frame(std::span<const Eigen::AlignedBox3d> boxes);
    /// View direction in radians: yaw around y from the front, pitch upwards.
    void setDirection(double yaw, double pitch);
    double yaw() const { return yaw_; }
    double pitch() const { return pitch_; }
    /// Turns perspective off. Sizes are then those at the target's depth.
    void setOrthographic(bool on) { orthographic_ = on; }
    bool isOrthographic() const { return orthographic_; }
    /// Interpolates target and distance towards another camera, keeping the direction; share 0 to
    /// 1.
    void moveTowards(const Camera3D& other, double share);

    /// Starts at the eye; without perspective, in front of all cloth.
    Ray ray(double x, double y) const;
    /// The point at the target's depth on the ray through a pixel.
    Eigen::Vector3d pointAtTargetDepth(double x, double y) const;
    /// Screen position of a point, in pixels; meaningless behind the eye.
    Eigen::Vector2d project(const Eigen::Vector3d& point) const;

    /// True if the point is in front of the eye.
    bool isBefore(const Eigen::Vector3d& point) const;
    /// Scale at the target's depth.
    double pixelsPerMillimetre() const { return pixelsPerUnitAtDepthOne() / distance_; }

    glm::dmat4 view() const;
    /// @param box the visible extent: near and far planes are set around it
    glm::dmat4 projection(const Eigen::AlignedBox3d& box) const;
    /// Offset to subtract from z in the clip space of that projection. It moves a point towards the
    /// eye by a share of its distance; without perspective, by that share of the distance to the
    /// target.
    double depthShift(const Eigen::AlignedBox3d& box, double share) const;
    Eigen::Vector3d eye() const;
    double distance() const { return distance_; }
    Eigen::Matrix3d axes() const;  ///< columns: right, up, towards the eye

private:
    struct DepthRange {
        double nearest, farthest;
    };
    DepthRange depthRange(const Eigen::AlignedBox3d& box) const;
    /// Distance in front of the target where orthographic rays start.
    double farBefore() const;
    /// Distance from the target at which the box fits in the current direction.
    double distanceToFit(const Eigen::AlignedBox3d& box) const;
    double pixelsPerUnitAtDepthOne() const;

    Eigen::Vector3d target_ = Eigen::Vector3d::Zero();
    double distance_ = 1000;
    double yaw_ = 0.45, pitch_ = 0.12;
    double width_ = 1, height_ = 1;
    double freeEdges_ = 0;
    bool orthographic_ = false;
};

}  // namespace toile::app
