// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/formats/drawing/drawing.h"
#include "core/formats/export_options.h"
#include "core/formats/pdf/pdf_pages.h"
#include "core/pattern/pattern.h"

namespace toile {

/// PDF 1.7 in true scale, on the pages of `planPages`. The drawing is stored once, as a form of
/// which each page shows a part. Each kind of line has a layer (optional content); the projector
/// also gets a grid of inches, initially off. No dates, and viewers are instructed not to scale.
/// Texts are filled outlines with the same text invisible. If there are tiles, the drawing's check
/// square is left out: the first page has squares.
/// @param pattern  the drawn pattern
/// Errors: those of planPages. Cost: that of pdfDrawing, and of the texts of each page. Pure.
Result<std::string> writePdf(const Drawing& drawing, const Pattern& pattern,
                             const PdfOptions& options);

/// The pages of such a file for the drawn content. Errors: those of planPages. Pure.
Result<PdfPlan> planPdf(const Drawing& drawing, const PdfOptions& options);

/// The kinds of lines in such a file, in tiles or on one page.
std::vector<LayerKind> pdfLayers(const Drawing& drawing, bool isTiled);

}  // namespace toile
