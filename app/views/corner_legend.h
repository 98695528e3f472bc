// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/views/colour_legend.h"

namespace toile::app {

/// How high a legend of LegendShape::Corner is where it is so wide, logical pixels: words that find
/// no room beside the title stand below it, in two lines at most.
int cornerLegendHeight(const ColourLegend& legend, const QFont& font, int width);

}  // namespace toile::app
