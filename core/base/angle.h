// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace toile {

/// One degree, in radians.
inline constexpr double kDegree = std::numbers::pi / 180;

}  // namespace toile
