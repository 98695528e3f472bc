// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/formats/drawing/drawing.h"
#include "core/formats/export_options.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

inline constexpr double kPlotterUnits = 40;  // per mm

/// A line in the whole units of a plotter. Rounding each of many points would make a zigzag that is
/// longer than the line. This keeps only as many points as needed, rounded so that the line is off
/// by at most 0.019 mm if its points are two units apart or more, and the length up to each point
/// is right within a few hundredths of a millimetre.
/// @param line  mm, one point or more  @return  #n x 2, whole numbers; a closed line repeats its
/// first point. Cost: linear in the points, times those passed by a step. Pure.
Points2 plotterLine(const Points2& line, bool closed);

/// HPGL in whole units, 40 per millimetre, y up, nothing negative: IN, PA, then for each pen PU and
/// lists of PD with at most 64 points. Pen 3 draws the outlines of letters, pen 2 all lines that
/// are not cut, pen 1 the cut lines: a piece's holes before its outline, which holds the cloth.
/// Closed lines end where they began. Lines are those of `plotterLine`. The turned drawing is
/// rotated a quarter anti-clockwise. Cost: linear in the points. Pure.
std::string writePlt(const Drawing& drawing, const PltOptions& options = {});

}  // namespace toile
