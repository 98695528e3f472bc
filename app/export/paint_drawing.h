// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QPainterPath>
#include <string>

#include "core/base/result.h"
#include "core/formats/drawing/drawing.h"
#include "core/formats/formats.h"

class QPainter;

namespace toile::app {

/// Paints the drawings of files, for previews, pictures and paper.

inline constexpr double kMillimetresPerInch = 25.4;

/// Visible parts of a drawing at a scale.
struct DrawingLook {
    double line = 0.3;  ///< width of lines, mm
    bool texts = true;
    bool check = true;  ///< the check square; tiled paper shows it elsewhere
};

/// Paints in the painter's units, which must be millimetres with y down and the origin in the
/// page's upper left corner. Cost: linear in the points and letters.
void paintDrawing(QPainter& painter, const Drawing& drawing, const DrawingLook& look = {});

/// A line of text as an area, y down; it starts at (0, 0) on the baseline.
struct Letters {
    QPainterPath path;
    double width = 0;
};

/// @param height  of a capital letter. Thread-safe and cost as `textOutlines`
Letters lettersOf(const std::string& line, double height);

/// Draws the whole drawing on white and stores the scale as the image's resolution.
/// @param dpi  dots per inch
/// Errors: PageTooSmall if the picture would exceed the maximum size.
Result<QImage> pictureOf(const Drawing& drawing, double dpi);

/// Registers the writers that need Qt in the table of formats. Call before writing any file.
void provideWriters();

}  // namespace toile::app
