// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/export/drawing.h"
#include "core/pattern/pattern.h"

namespace toile {

class PdfLetters;

/// Widths of lines, mm, by the kinds.
struct PdfLineWidths {
    double cut = 0.35, others = 0.25, marks = 0.18;
};

/// A whole drawing as one content stream in millimetres, y up: layer by layer, each line known by
/// its id and its piece. Seam lines of pieces whose outline stands for a curve are written as the
/// curves of `curvesOf`, where these keep to the line; everything else by its points.
/// @param pattern  that was drawn  @param layers  that are written, in this order
/// @param letters  of the file, which get the texts
/// Cost: linear, and that of `curvesOf` per segment and of `textOutlines` per text. Pure.
std::string pdfDrawing(const Drawing& drawing, const Pattern& pattern,
                       const std::vector<LayerKind>& layers, const PdfLineWidths& widths,
                       PdfLetters& letters);

}  // namespace toile
