// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile {

/// mm from the origin: farther away nothing is laid.
inline constexpr double kFarthestOnSheet = 1e9;

}  // namespace toile
