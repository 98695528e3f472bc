// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/drawing/drawing.h"
#include "core/formats/drawing/sheet_drawing.h"
#include "core/formats/pdf/pdf_pages.h"

namespace toile {

/// The contents of the sheets of a plan, for PDF files and printers.

/// Sides of the squares for checking a print, mm.
inline constexpr double kMetricSquare = 50, kInchSquare = 25.4;

/// The place of the two squares, side by side next to the drawing's own check square, in the
/// drawing. Empty if it has none.
Eigen::AlignedBox2d squaresBeside(const Drawing& drawing);

/// Number of pages of the plan, including the page with the map if there are tiles.
std::size_t sheetCount(const PdfPlan& plan);
/// The size of a sheet, mm.
Eigen::Vector2d sheetPaper(const PdfPlan& plan, std::size_t sheet);

/// Draws a sheet. With tiles, the first sheet has the title, instructions for printing and joining,
/// the two squares and a map of the tiles. Each following sheet has its part of the drawing, the
/// frame for cutting, half of each mark shared with a neighbour, the neighbours' names, its own
/// name and its number. Without tiles: the whole drawing, with the two squares.
/// @param sheet  below sheetCount  @param hasGrid  of inches, on its own layer; not on tiles
void drawSheet(SheetCanvas& out, const Drawing& drawing, const PdfPlan& plan, std::size_t sheet,
               bool hasGrid = false);

}  // namespace toile
