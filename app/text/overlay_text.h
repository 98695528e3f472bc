// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "app/document/view_state.h"

namespace toile::app {

/// What an overlay is called and how its numbers are read.
struct OverlayWords {
    QString title;
    QString unit;  ///< "%", "°"; empty where there are no numbers
    QString meaning;
};

OverlayWords overlayWords(Overlay overlay);

/// Digits as they come, at most four: "+12.5", "−3"; without the unit.
QString overlayNumber(Overlay overlay, double value);
/// A measured value, always with the same decimals, and its unit: "+2.4 %", "3.1°".
QString overlayValueText(Overlay overlay, double value);

}  // namespace toile::app
