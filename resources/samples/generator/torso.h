// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "curves.h"

namespace toile::samples {

enum class Half { Front, Back };

/// A soft mound that pushes the surface outwards: bust, belly, shoulder blade, seat.
struct Mound {
    double x = 0.0;  ///< centre, mm; there is one on either side of the body
    double y = 0.0;
    double across = 0.0;  ///< reach towards either side (one standard deviation)
    double above = 0.0;   ///< reach upwards
    double below = 0.0;   ///< reach downwards
    double rise = 0.0;    ///< mm at the centre
};

/// Sum of the mounds and their mirror images at a point seen from the front.
double moundRise(const std::vector<Mound>& mounds, double x, double y);

/// Measures of an upper garment on the body, mm. Heights are above the floor.
struct TorsoShape {
    Profile halfWidth;
    Profile frontDepth;
    Profile backDepth;
    std::vector<Mound> frontMounds;
    std::vector<Mound> backMounds;
    double bendHeight = 0.0;  ///< from here up the sides lean in to the shoulder line
    double riseLength = 0.0;  ///< layout length from the bend to the shoulder line
    double widening = 0.0;    ///< growth of widths from the bend to the shoulder line, as a part
    double neckX = 0.0;       ///< where the shoulder line meets the neck
    double neckY = 0.0;
    double shoulderSlope = 0.0;  ///< fall of the shoulder line per mm outwards
    double shoulderZ = 0.0;      ///< depth of the shoulder line
    double squareness = 0.0;     ///< part by which the sections bulge at the diagonals
};

/// A smooth torso without folds. The layout of each half has x along the body from the centre
/// (to the viewer's right) and y upwards: the height up to the bend, then the way over the
/// shoulder. Front and back meet at the sides and along the shoulder line.
class Torso {
public:
    explicit Torso(TorsoShape shape) : shape_(std::move(shape)) {}

    /// Point at `angle` from the centre (radians, positive to the wearer's left) and layout height.
    Vec3 at(Half half, double angle, double height) const;

    /// Point of the layout.
    Vec3 fromFlat(Half half, Vec2 flat) const;

    /// Layout point of an angle and layout height.
    Vec2 toFlat(Half half, double angle, double height) const;

    /// Layout height of the shoulder line.
    double shoulderHeight() const { return shape_.bendHeight + shape_.riseLength; }

private:
    double ridgeHeight(double x) const;
    double girthRadius(Half half, double height) const;

    TorsoShape shape_;
};

}  // namespace toile::samples
