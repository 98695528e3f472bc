// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/export/drawing.h"
#include "core/pattern/cubic_curve.h"

namespace toile {

/// The outlines of a text (`textOutlines`) placed in the drawing, mm, y up; none without fonts.
std::vector<std::vector<CubicCurve>> placedOutlines(const DrawnText& text);

}  // namespace toile
