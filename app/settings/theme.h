// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>

#include "app/settings/choices.h"

namespace toile::app {

/// Light and dark window palettes. Text has a contrast of at least 4.5 to its background.
QPalette lightPalette();
QPalette darkPalette();

/// Applies the theme to the running application. `System` restores the desktop's style and colours
/// and follows their changes. The first call must come before any window is created. GUI thread
/// only.
void applyTheme(Theme theme);

}  // namespace toile::app
