// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

#include "core/export/export_source.h"

namespace toile::app {

/// Exports a pattern to files, and says of each that it is written and how it reads back, or why it
/// is not. @return whether all are written
bool writePatterns(const std::vector<std::filesystem::path>& outputs, const ExportSource& source,
                   std::ostream& out, std::ostream& err);

}  // namespace toile::app
