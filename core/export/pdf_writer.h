// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/export/drawing.h"
#include "core/export/export_options.h"
#include "core/export/pdf_pages.h"
#include "core/pattern/pattern.h"

namespace toile {

/// PDF 1.7 in true scale, by pages of `planPages`: the drawing once, as a form that every page
/// shows a part of; a layer (optional content) for each kind of line, and for the projector a grid
/// of inches that is off at first; no dates, and viewers are told not to scale. Texts are filled
/// outlines, with the same text beside them unseen.
/// Where there are tiles the drawing's check square is left out: the first page has squares.
/// @param pattern  that was drawn
/// Errors: those of planPages. Cost: that of pdfDrawing, and of the texts of each page. Pure.
Result<std::string> writePdf(const Drawing& drawing, const Pattern& pattern,
                             const PdfOptions& options);

/// The pages of such a file: those of what is drawn. Errors: those of planPages. Pure.
Result<PdfPlan> planPdf(const Drawing& drawing, const PdfOptions& options);

/// The kinds of lines that such a file carries, in tiles or on one page.
std::vector<LayerKind> pdfLayers(const Drawing& drawing, bool isTiled);

}  // namespace toile
