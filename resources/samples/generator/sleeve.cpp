// SPDX-License-Identifier: GPL-3.0-or-later
#include "sleeve.h"

namespace toile::samples {

namespace {

constexpr Vec3 kArm{0.71, -0.70414, 0.0};        // along the arm
constexpr Vec3 kAcross{0.70414, 0.71, 0.0};      // from underarm to top
constexpr Vec3 kShoulderFall{0.93, -0.36, 0.0};  // goes on along the shoulder line
constexpr Vec3 kCuffCentre{348.0, 1206.0, -6.0};
constexpr double kCuffRadius = 67.0;
constexpr double kCuffWidth = 421.0;
constexpr double kCapWidth = 455.0;
constexpr double kUnderarmLength = 145.0;
constexpr double kTopLength = 265.0;
constexpr double kSpread = 0.25;  // how far front and back lean apart at the armhole

/// 0 at the underarm, 1 at the shoulder.
double shoulderness(double around) {
    return 0.5 - 0.5 * std::cos(2.0 * kPi * around);
}

Vec3 cuff(double around) {
    const double angle = 2.0 * kPi * around;
    return kCuffCentre + (-kCuffRadius * std::cos(angle)) * kAcross +
           Vec3{0.0, 0.0, kCuffRadius * std::sin(angle)};
}

double widthAt(double y) {
    return kCuffWidth + (kCapWidth - kCuffWidth) * y / kUnderarmLength;
}

double lengthAt(double around) {
    return kUnderarmLength + (kTopLength - kUnderarmLength) * shoulderness(around);
}

}  // namespace

Sleeve::Sleeve(const SeamLine& frontArmhole, const SeamLine& backArmhole)
    : armhole_(joinSeams({{&frontArmhole, false}, {&backArmhole, true}}), PointCurve::Ends::Closed),
      frontPart_(static_cast<double>(frontArmhole.points.size() - 1) /
                 static_cast<double>(frontArmhole.points.size() + backArmhole.points.size() - 2)) {}

Vec3 Sleeve::at(double around, double down) const {
    const Vec3 top = armhole_(around);
    const Vec3 end = cuff(around);
    const double span = length(end - top);
    const double up = shoulderness(around);
    const Vec3 leave = normalized((1.0 - up) * kArm + up * kShoulderFall +
                                  Vec3{0.0, 0.0, kSpread * std::sin(2.0 * kPi * around)});
    const Vec3 a = top + (0.33 * span) * leave;
    const Vec3 b = end - (0.30 * span) * kArm;
    return {bezier(top.x, a.x, b.x, end.x, down), bezier(top.y, a.y, b.y, end.y, down),
            bezier(top.z, a.z, b.z, end.z, down)};
}

Vec3 Sleeve::fromFlat(Vec2 p) const {
    const double around = p.x / widthAt(p.y) + 0.5;
    return at(around, 1.0 - p.y / lengthAt(around));
}

Vec2 Sleeve::toFlat(double around, double down) const {
    const double y = (1.0 - down) * lengthAt(around);
    return {(around - 0.5) * widthAt(y), y};
}

}  // namespace toile::samples
