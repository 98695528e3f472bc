// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <glm/mat4x4.hpp>

namespace toile::app {

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
    /// Of the slider over the lower edge of the garment's view, logical pixels.
    static constexpr double kSliderRoom = 46;
    /// What framing leaves free at the upper and lower edge, logical pixels.
    void setFreeEdges(double pixels) { freeEdges_ = pixels; }

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
    double yaw() const { return yaw_; }
    double pitch() const { return pitch_; }
    /// Without perspective: what is parallel stays so; sizes are those at the target's depth.
    void setOrthographic(bool on) { orthographic_ = on; }
    bool isOrthographic() const { return orthographic_; }
    /// Comes nearer to another camera's target and distance, keeping its own direction; share 0 to
    /// 1.
    void moveTowards(const Camera3D& other, double share);

    /// Starts before all cloth, at the eye where there is perspective.
    Ray ray(double x, double y) const;
    /// Point on the ray through a pixel at the target's depth.
    Eigen::Vector3d pointAtTargetDepth(double x, double y) const;
    /// Screen place of a point, in pixels; meaningless behind the eye.
    Eigen::Vector2d project(const Eigen::Vector3d& point) const;

    /// True where the point lies before the eye.
    bool isBefore(const Eigen::Vector3d& point) const;
    /// Of what lies at the target's depth.
    double pixelsPerMillimetre() const { return pixelsPerUnitAtDepthOne() / distance_; }

    glm::dmat4 view() const;
    /// @param box what is to be seen: near and far are set around it
    glm::dmat4 projection(const Eigen::AlignedBox3d& box) const;
    /// What has to be taken from z in the clip space of that projection to come nearer to the eye
    /// by a share of the distance to it, wherever that is; without perspective by that share of
    /// the distance to the target.
    double depthShift(const Eigen::AlignedBox3d& box, double share) const;
    Eigen::Vector3d eye() const;
    double distance() const { return distance_; }
    Eigen::Matrix3d axes() const;  ///< columns: right, up, towards the eye

private:
    struct DepthRange {
        double nearest, farthest;
    };
    DepthRange depthRange(const Eigen::AlignedBox3d& box) const;
    /// From where rays start that have no eye to start from, before the target.
    double farBefore() const;
    /// Distance from the target at which the box fits, as seen from the present direction.
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
