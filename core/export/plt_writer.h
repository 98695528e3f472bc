// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/export/drawing.h"
#include "core/export/export_options.h"

namespace toile {

/// HPGL in whole units, 40 to the millimetre, y up, nothing negative: IN, PA, then each pen with
/// PU and lists of PD of at most 64 points. Pen 3 draws the outlines of letters, pen 2 every line
/// that is not cut, pen 1 what is, a piece's holes before its outline: what holds the cloth comes
/// last. Closed lines end where they began. Lines as `plotterLine` has them. Turned, the drawing is
/// by a quarter anti-clockwise. Cost: linear in the points. Pure.
std::string writePlt(const Drawing& drawing, const PltOptions& options = {});

}  // namespace toile
