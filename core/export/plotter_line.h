// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh_arrays.h"

namespace toile {

inline constexpr double kPlotterUnits = 40;  // per mm

/// A line in the whole units of a plotter. Rounding each of many points would make a zigzag that is
/// longer than the line; here only as many are kept as it takes, so chosen and so rounded that the
/// line is no more than 0.019 mm off, where its points are two units apart or more, and the length
/// up to any of them is right to some hundredths of a millimetre.
/// @param line  mm, one point or more  @return  #n x 2, whole; a closed one with its first point
/// once more. Cost: linear in the points, times what a step passes over. Pure.
Points2 plotterLine(const Points2& line, bool closed);

}  // namespace toile
