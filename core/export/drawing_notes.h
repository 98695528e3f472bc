// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/wording.h"
#include "core/export/drawing.h"

namespace toile {

/// Notes to read before using a drawing. Empty if there is nothing to report.

/// Lists pieces whose cut lines overlap on the page, with a remedy, in one note.
/// Cost: as `overlappingOutlines`. Pure.
std::vector<Wording> overlapNotes(const Pattern& pattern, const Drawing& drawing);
/// Lists pieces drawn without a grain line because their grain is not stated, in one note. Pure.
std::vector<Wording> grainNotes(const Pattern& pattern, const Drawing& drawing);

}  // namespace toile
