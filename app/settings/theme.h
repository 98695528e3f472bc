// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>

#include "app/settings/choices.h"

namespace toile::app {

/// Colours of a window, light or dark: letters reach a contrast of 4.5 on what they stand on.
QPalette lightPalette();
QPalette darkPalette();

/// Gives the running application the theme, at once. With `System` it has the desktop's own style
/// and colours, as at the start, and follows their changes. Call it first before any window is
/// made. GUI thread only.
void applyTheme(Theme theme);

}  // namespace toile::app
