// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/garment/fabric.h"

namespace toile::app {

/// Name of a fabric inside a sentence: "jersey"; "custom" if it is no preset.
QString fabricName(const Fabric& fabric);

}  // namespace toile::app
