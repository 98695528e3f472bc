// SPDX-License-Identifier: GPL-3.0-or-later
#include "torso.h"

#include <algorithm>

namespace toile::samples {

namespace {

constexpr double kRidgeRounding = 45.0;  // mm; keeps the shoulder line smooth across the centre

double bell(double distance, double reach) {
    const double ratio = distance / reach;
    return std::exp(-0.5 * ratio * ratio);
}

}  // namespace

double moundRise(const std::vector<Mound>& mounds, double x, double y) {
    double sum = 0.0;
    for (const Mound& mound : mounds) {
        const double upright = bell(y - mound.y, y > mound.y ? mound.above : mound.below);
        sum += mound.rise * upright *
               (bell(x - mound.x, mound.across) + bell(x + mound.x, mound.across));
    }
    return sum;
}

double Torso::ridgeHeight(double x) const {
    const auto fall = [](double distance) { return std::hypot(distance, kRidgeRounding); };
    return shape_.neckY - shape_.shoulderSlope * (fall(x) - fall(shape_.neckX));
}

double Torso::girthRadius(Half half, double height) const {
    const double a = shape_.halfWidth(height);
    const double b = half == Half::Front ? shape_.frontDepth(height) : shape_.backDepth(height);
    return std::sqrt(0.5 * (a * a + b * b));
}

Vec3 Torso::at(Half half, double angle, double height) const {
    const TorsoShape& s = shape_;
    const double level = std::min(height, s.bendHeight);
    const bool front = half == Half::Front;
    const double out = front ? 1.0 : -1.0;
    const double diagonal = std::sin(2.0 * angle);
    const double bulge = 1.0 + s.squareness * diagonal * diagonal;
    const double depth = front ? s.frontDepth(level) : s.backDepth(level);

    Vec3 p;
    p.x = s.halfWidth(level) * std::sin(angle) * bulge;
    p.y = level;
    p.z = out * depth * std::cos(angle) * bulge;
    double fade = std::cos(angle);
    if (height > s.bendHeight) {
        const double t = (height - s.bendHeight) / s.riseLength;
        p.x *= 1.0 + s.widening * smoothStep(t);
        const double rise = ridgeHeight(p.x) - s.bendHeight;
        p.y = s.bendHeight + rise * bezier(0.0, 0.38, 0.94, 1.0, t);
        p.z = bezier(p.z, p.z, s.shoulderZ + 0.70 * (p.z - s.shoulderZ), s.shoulderZ, t);
        fade *= (1.0 - t * t) * (1.0 - t * t);
    }
    p.z += out * fade * moundRise(front ? s.frontMounds : s.backMounds, p.x, p.y);
    return p;
}

Vec3 Torso::fromFlat(Half half, Vec2 flat) const {
    const double angle = flat.x / girthRadius(half, flat.y);
    return at(half, half == Half::Front ? angle : -angle, flat.y);
}

Vec2 Torso::toFlat(Half half, double angle, double height) const {
    const double x = angle * girthRadius(half, height);
    return {half == Half::Front ? x : -x, height};
}

}  // namespace toile::samples
