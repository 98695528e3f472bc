// SPDX-License-Identifier: GPL-3.0-or-later
#include "leg.h"

#include <algorithm>

namespace toile::samples {

namespace {

constexpr double kCurveHeight = 175.0;  // the crotch seam bends over this height
constexpr double kSideZ = -6.0;         // depth of side seam and inseam

}  // namespace

Vec3 Leg::at(Half half, double turn, double height) const {
    const double outer = outerX_(height);
    const double overlap = overlapAt(height);
    const bool front = half == Half::Front;
    const double out = front ? 1.0 : -1.0;
    const double x = outer / (1.0 + overlap) * (overlap + std::cos(turn));
    const double depth = (front ? frontDepth_(height) : backDepth_(height)) +
                         moundRise(front ? belly_ : seat_, x, height);
    return {x, height, kSideZ + out * depth * std::sin(turn)};
}

double Leg::innerTurn(double height) const {
    const double overlap = overlapAt(height);
    return height <= kCrotchHeight || overlap >= 1.0 ? kPi : std::acos(-overlap);
}

Vec3 Leg::fromFlat(Half half, Vec2 p) const {
    const double turn = p.x / radiusAt(half, p.y);
    return at(half, half == Half::Front ? -turn : turn, p.y);
}

Vec2 Leg::toFlat(Half half, double turn, double height) const {
    const double x = turn * radiusAt(half, height);
    return {half == Half::Front ? -x : x, height};
}

/// Ratio of the leg's centre x to its half width: 0 where both legs are one, 1 at the crotch
/// point, more where the legs stand apart.
double Leg::overlapAt(double height) const {
    const double outer = outerX_(height);
    if (height <= kCrotchHeight) {
        const double inner = innerX_(height);
        return (outer + inner) / (outer - inner);
    }
    const double t = (height - kCrotchHeight) / kCurveHeight;
    if (t >= 1.0) {
        return 0.0;
    }
    // Goes on from below with the slope at which the legs part there.
    constexpr double kStep = 1.0;  // mm
    const double partingSlope = innerX_(kCrotchHeight - kStep) / kStep;
    const double start = 2.0 * partingSlope * kCurveHeight / outer;
    return bezier(1.0, std::max(0.0, 1.0 - start / 3.0), 0.0, 0.0, t);
}

double Leg::radiusAt(Half half, double height) const {
    const double a = outerX_(height) / (1.0 + overlapAt(height));
    const double b = half == Half::Front ? frontDepth_(height) : backDepth_(height);
    return std::sqrt(0.5 * (a * a + b * b));
}

}  // namespace toile::samples
