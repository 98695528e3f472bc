// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/export/drawing.h"
#include "core/export/sheet_canvas.h"
#include "core/pattern/pattern.h"

namespace toile {

/// Line widths, mm, by kind of line.
struct SheetLineWidths {
    double cut = 0.35, others = 0.25, marks = 0.18;
};

/// Draws the whole drawing, in its own coordinates: layer by layer, each line with its id and its
/// piece. Seam lines of pieces with a curved outline are drawn as the curves of `curvesOf`, if
/// these stay close to the line; everything else by its points.
/// @param pattern  the drawn pattern  @param layers  to draw, in this order
/// Cost: linear, and that of `curvesOf` per segment and of the canvas per text.
void drawPattern(SheetCanvas& out, const Drawing& drawing, const Pattern& pattern,
                 const std::vector<LayerKind>& layers, const SheetLineWidths& widths = {});

}  // namespace toile
