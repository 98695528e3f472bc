// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/cubic_curve.h"

#include <cassert>

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr int kLengthParts = 8;
// Gauss' rule with five nodes, on [-1, 1].
constexpr double kPlaces[] = {0, 0.5384693101056831, 0.9061798459386640};
constexpr double kWeights[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};

}  // namespace

Vector2d CubicCurve::at(double t) const {
    const double s = 1 - t;
    return s * s * s * start + 3 * s * s * t * startHandle + 3 * s * t * t * endHandle +
           t * t * t * end;
}

Vector2d CubicCurve::derivative(double t) const {
    const double s = 1 - t;
    return 3 * (s * s * (startHandle - start) + 2 * s * t * (endHandle - startHandle) +
                t * t * (end - endHandle));
}

CubicCurve straightCurve(const Vector2d& start, const Vector2d& end) {
    return {start, start + (end - start) / 3, end + (start - end) / 3, end, true};
}

double curveLength(const CubicCurve& curve) {
    if (curve.isLine) {
        return (curve.end - curve.start).norm();
    }
    const double half = 0.5 / kLengthParts;
    double length = 0;
    for (int part = 0; part < kLengthParts; ++part) {
        const double middle = (2 * part + 1) * half;
        length += half * kWeights[0] * curve.derivative(middle).norm();
        for (const int k : {1, 2}) {
            length += half * kWeights[k] *
                      (curve.derivative(middle - half * kPlaces[k]).norm() +
                       curve.derivative(middle + half * kPlaces[k]).norm());
        }
    }
    return length;
}

double curveLength(const std::vector<CubicCurve>& chain) {
    double length = 0;
    for (const CubicCurve& curve : chain) {
        length += curveLength(curve);
    }
    return length;
}

Points2 sampled(const std::vector<CubicCurve>& chain, int perCurve) {
    assert(perCurve > 0);
    if (chain.empty()) {
        return Points2(0, 2);
    }
    Points2 points(static_cast<Eigen::Index>(chain.size()) * perCurve + 1, 2);
    Eigen::Index row = 0;
    for (const CubicCurve& curve : chain) {
        for (int k = 0; k < perCurve; ++k) {
            points.row(row++) = curve.at(static_cast<double>(k) / perCurve);
        }
    }
    points.row(row) = chain.back().end;
    return points;
}

}  // namespace toile
