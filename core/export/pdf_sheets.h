// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/export/drawing.h"
#include "core/export/pdf_pages.h"

namespace toile {

class PdfLetters;

/// What stands on the pages of a PDF file, as content streams in points. The drawing is the form
/// "P" of their resources, in millimetres; `letters` of the same file get the texts.

/// Sides of the squares by which a print is checked, mm.
inline constexpr double kMetricSquare = 50, kInchSquare = 25.4;

/// Where the two squares stand side by side beside a drawing's own check square, in the drawing.
/// Empty where it has none.
Eigen::AlignedBox2d squaresBeside(const Drawing& drawing);

/// The first page of a pattern in tiles: what it is, how it is printed and put together, the two
/// squares, and a map of the tiles.
std::string coverPage(const Drawing& drawing, const PdfPlan& plan, PdfLetters& letters);
/// A tile: the part of the drawing, the frame along which it is cut, half of each mark that is
/// shared with a neighbour, the neighbours' names, its own, and its number.
std::string tilePage(const Drawing& drawing, const PdfPlan& plan, std::size_t page,
                     PdfLetters& letters);
/// All of the drawing on one page, with the two squares.
/// @param hasGrid  of inches, on a layer of its own
std::string singlePage(const Drawing& drawing, const PdfPlan& plan, bool hasGrid,
                       PdfLetters& letters);

}  // namespace toile
