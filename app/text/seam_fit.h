// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

#include "core/seam/seam_fit.h"

namespace toile {

/// "matches", "nearly", "does not match"; empty where unknown.
QString fitWord(SeamFit fit);
/// Green, amber, red; told apart by lightness too. Invalid where unknown.
QColor fitColour(SeamFit fit);
/// A disc with a tick, a triangle with an exclamation mark, a square with a cross.
QIcon fitMark(SeamFit fit);

}  // namespace toile
