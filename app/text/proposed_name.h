// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace toile::app {

/// What a cut that the core proposes is called in the person's language, "left side 2" with its
/// number: the name that it keeps where it is made. What is not known stays as it is.
std::string proposedName(const std::string& name);

/// Likewise what a part of a garment is called (`partName`): "left sleeve".
std::string proposedPartName(const std::string& name);

}  // namespace toile::app
