// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/curve_parts.h"

#include <cmath>

namespace toile {
namespace {

constexpr int kHalvings = 50;

/// The parameter at which a curve has this length.
double parameterAt(const CubicCurve& curve, double length) {
    if (curve.isLine) {
        return length / curveLength(curve);
    }
    double low = 0, high = 1;
    for (int k = 0; k < kHalvings; ++k) {
        const double middle = (low + high) / 2;
        (curveLength(dividedAt(curve, middle)[0]) < length ? low : high) = middle;
    }
    return (low + high) / 2;
}

}  // namespace

std::array<CubicCurve, 2> dividedAt(const CubicCurve& curve, double t) {
    const auto between = [t](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return Eigen::Vector2d(a + t * (b - a));
    };
    if (curve.isLine) {
        const Eigen::Vector2d place = between(curve.start, curve.end);
        return {straightCurve(curve.start, place), straightCurve(place, curve.end)};
    }
    const Eigen::Vector2d a = between(curve.start, curve.startHandle),
                          b = between(curve.startHandle, curve.endHandle),
                          c = between(curve.endHandle, curve.end), ab = between(a, b),
                          bc = between(b, c), place = between(ab, bc);
    return {CubicCurve{curve.start, a, ab, place}, CubicCurve{place, bc, c, curve.end}};
}

std::vector<CubicCurve> dividedChain(const std::vector<CubicCurve>& chain,
                                     const std::vector<double>& places, double near) {
    std::vector<CubicCurve> parts;
    std::size_t next = 0;
    double begin = 0;
    for (CubicCurve rest : chain) {
        double length = curveLength(rest);
        const double end = begin + length;
        while (next < places.size() && places[next] <= begin + near) {
            ++next;
        }
        for (; next < places.size() && places[next] < end - near; ++next) {
            if (places[next] <= begin + near) {
                continue;
            }
            auto [before, after] = dividedAt(rest, parameterAt(rest, places[next] - begin));
            parts.push_back(before);
            rest = after;
            begin = places[next];
        }
        parts.push_back(rest);
        begin = end;
    }
    return parts;
}

std::vector<double> jointsOf(const std::vector<CubicCurve>& chain) {
    std::vector<double> joints;
    double at = 0;
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
        joints.push_back(at += curveLength(chain[k]));
    }
    return joints;
}

}  // namespace toile
