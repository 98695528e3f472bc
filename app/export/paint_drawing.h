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

/// The drawing of files, painted: for previews, pictures and paper alike.

inline constexpr double kMillimetresPerInch = 25.4;

/// What of a drawing is seen at a scale.
struct DrawingLook {
    double line = 0.3;  ///< width of lines, mm
    bool texts = true;
    bool check = true;  ///< the check square, which tiles of paper have in another place
};

/// Paints in the painter's units, which are millimetres with y down, the page's upper left corner
/// at the origin. Cost: linear in the points and letters.
void paintDrawing(QPainter& painter, const Drawing& drawing, const DrawingLook& look = {});

/// A line of text as one area, y down, from (0, 0) on the baseline to the right.
struct Letters {
    QPainterPath path;
    double width = 0;
};

/// @param height  of a capital. Cost: that of `textOutlines`; as that, thread-safe
Letters lettersOf(const std::string& line, double height);

/// The whole drawing on white, with the scale kept as the picture's resolution.
/// @param dpi  dots per inch
/// Errors: PageTooSmall where the picture would be larger than pictures can be.
Result<QImage> pictureOf(const Drawing& drawing, double dpi);

/// Gives the table of formats the writers that need Qt. Before anything is written.
void provideWriters();

}  // namespace toile::app
