// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

// For the sources of this folder only.
namespace toile::isometric {

/// Where a t² + b t + c is 0, without cancellation. Not a number where it is nowhere; where it has
/// one root only, the other is infinite or no number.
inline std::array<double, 2> quadraticRoots(double a, double b, double c) {
    const double q = -0.5 * (b + std::copysign(std::sqrt(b * b - 4 * a * c), b));
    return {q / a, c / q};
}

}  // namespace toile::isometric
