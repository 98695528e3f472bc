// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/export/garmentcode_panels.h"
#include "core/export/read_back.h"

namespace toile {

/// GarmentCode's JSON: centimetres, each edge straight or one cubic curve relative to its chord,
/// stitches edge to edge, panels at their place in the garment (turned about x, then y, then z).
/// Keys in the order of GarmentCode's own files. Cost: linear. Pure.
std::string writeGarmentCode(const SewnPanels& panels);

/// Reads such a file and compares it with its pattern: each panel is there once, its vertices are
/// on the piece's outline, edges are as long as the outline between them, and stitches together
/// cover each seam on both sides.
/// @param pattern  whole  Errors: NotReadBack, with the panel and the figure. Pure.
Result<ReadBack> readBackGarmentCode(const std::string& bytes, const Pattern& pattern);

}  // namespace toile
