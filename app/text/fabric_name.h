// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/garment/fabric.h"

namespace toile::app {

/// What a fabric is called within a sentence: "jersey"; "custom" for one that is no preset.
QString fabricName(const Fabric& fabric);

}  // namespace toile::app
