// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace toile {

inline constexpr double kPi = std::numbers::pi;
/// One degree, in radians.
inline constexpr double kDegree = kPi / 180;

}  // namespace toile
