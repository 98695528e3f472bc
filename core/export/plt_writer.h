// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/export/drawing.h"
#include "core/export/export_options.h"

namespace toile {

/// HPGL in whole units, 40 per millimetre, y up, nothing negative: IN, PA, then for each pen PU and
/// lists of PD with at most 64 points. Pen 3 draws the outlines of letters, pen 2 all lines that
/// are not cut, pen 1 the cut lines: a piece's holes before its outline, which holds the cloth.
/// Closed lines end where they began. Lines are those of `plotterLine`. The turned drawing is
/// rotated a quarter anti-clockwise. Cost: linear in the points. Pure.
std::string writePlt(const Drawing& drawing, const PltOptions& options = {});

}  // namespace toile
