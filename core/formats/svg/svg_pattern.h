// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/base/result.h"
#include "core/formats/pattern_file.h"

namespace toile {

/// Reads an SVG drawing as a pattern. Toile's own files name piece and layer of each line. In
/// others each outer closed line is a piece; closed lines inside it are holes, or its seam line if
/// they fill most of it.
/// @param stated  unit of the coordinates, set by the user if the file is not at true scale
/// Errors: MalformedFile, NoGeometry (no closed line). Cost: linear; for other programs' files also
/// pieces times points. Pure.
Result<PatternFile> readSvgPattern(std::string_view bytes,
                                   std::optional<FileUnit> stated = std::nullopt);

}  // namespace toile
