// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile {

/// The most ease that can be stated, as a part of the seam's right side: ten times as long again.
inline constexpr double kMostEase = 10;

}  // namespace toile
