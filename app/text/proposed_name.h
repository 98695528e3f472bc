// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace toile::app {

/// Translates the name of a proposed cut, "left side 2", which the cut keeps when it is made.
/// Unknown names stay unchanged.
std::string proposedName(const std::string& name);

/// Translates the name of a garment part (`partName`): "left sleeve".
std::string proposedPartName(const std::string& name);

}  // namespace toile::app
