// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

// For the sources of this folder only.
namespace toile::isometric {

/// The roots of a t² + b t + c, without cancellation. NaN if there are none; if there is only one,
/// the other is infinite or NaN.
inline std::array<double, 2> quadraticRoots(double a, double b, double c) {
    const double q = -0.5 * (b + std::copysign(std::sqrt(b * b - 4 * a * c), b));
    return {q / a, c / q};
}

}  // namespace toile::isometric
