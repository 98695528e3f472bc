// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/export/garmentcode_panels.h"
#include "core/export/read_back.h"

namespace toile {

/// GarmentCode's JSON: centimetres, each edge straight or one cubic curve relative to its chord,
/// stitches edge to edge, panels where they lie in the garment (turned about x, then y, then z).
/// Keys in the order of that program's own files.  Cost: linear. Pure.
std::string writeGarmentCode(const SewnPanels& panels);

/// Reads such a file again and compares it with the pattern it is of: each panel there once, its
/// vertices on the piece's outline, edges as long as the outline between them, and stitches that
/// together cover each seam on both sides.
/// @param pattern  whole  Errors: NotReadBack, with the panel and the figure. Pure.
Result<ReadBack> readBackGarmentCode(const std::string& bytes, const Pattern& pattern);

}  // namespace toile
