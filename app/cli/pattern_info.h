// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <iosfwd>

#include "app/cli/arguments.h"

namespace toile::app {

/// Whether the name says that a file holds a pattern and no garment.
bool isPatternFile(const std::filesystem::path& path);

/// `toile info` of pattern files: pieces, sizes, layers, lengths, and how the unit is known.
/// @return the exit status
int runPatternInfo(const Arguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace toile::app
