// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/drawing.h"
#include "core/export/pdf_pages.h"
#include "core/export/sheet_canvas.h"

namespace toile {

/// What stands on the sheets of a plan, in a PDF file and on paper alike.

/// Sides of the squares by which a print is checked, mm.
inline constexpr double kMetricSquare = 50, kInchSquare = 25.4;

/// Where the two squares stand side by side beside a drawing's own check square, in the drawing.
/// Empty where it has none.
Eigen::AlignedBox2d squaresBeside(const Drawing& drawing);

/// The pages of the plan, after that with the map where there are tiles.
std::size_t sheetCount(const PdfPlan& plan);
/// How large a sheet is, mm.
Eigen::Vector2d sheetPaper(const PdfPlan& plan, std::size_t sheet);

/// Draws a sheet. In tiles the first says what it is, how it is printed and put together, with the
/// two squares and a map of the tiles; each that follows has its part of the drawing, the frame
/// along which it is cut, half of each mark that is shared with a neighbour, the neighbours' names,
/// its own, and its number. Else all of the drawing, with the two squares.
/// @param sheet  below sheetCount  @param hasGrid  of inches, on a layer of its own; not on tiles
void drawSheet(SheetCanvas& out, const Drawing& drawing, const PdfPlan& plan, std::size_t sheet,
               bool hasGrid = false);

}  // namespace toile
