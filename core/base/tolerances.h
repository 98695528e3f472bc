// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile {

/// Named tolerances, all relative to the perimeter, an edge or an area, so that results do not
/// depend on the size or unit of a piece.

/// Closing gap of an outline, relative to its perimeter, below which it counts as closed.
inline constexpr double kClosureTolerance = 1e-10;
/// A triangle whose height is below this fraction of its longest edge has no usable angles: its
/// cotangents would leave fewer than half of a double's digits.
inline constexpr double kDegenerateHeight = 1e-10;
/// A boundary edge shorter than this fraction of the perimeter counts as having no length.
inline constexpr double kZeroLengthEdge = 1e-13;

}  // namespace toile
