// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/base/result.h"
#include "core/reading/pattern_file.h"

namespace toile {

/// An SVG drawing as a pattern: ours, by the piece and the layer that each line names; of others
/// each outer closed line is a piece, and what is closed inside of it a hole, or the seam line
/// where it fills most of it.
/// @param stated  the unit of its numbers, where a person says that the file is not at true scale
/// Errors: MalformedFile, NoGeometry (no closed line). Cost: linear, of other programs' files also
/// pieces times points. Pure.
Result<PatternFile> readSvgPattern(std::string_view bytes,
                                   std::optional<FileUnit> stated = std::nullopt);

}  // namespace toile
