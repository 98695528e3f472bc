// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/reading/pattern_file.h"

namespace toile {

/// Describes a pattern file as JSON: format, unit and its source, sizes, and each piece with its
/// lengths (mm), area (mm2) and counts. Never NaN: null. Cost: linear. Pure.
std::string writePatternFile(const PatternFile& file);

}  // namespace toile
