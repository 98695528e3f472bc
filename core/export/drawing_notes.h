// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/wording.h"
#include "core/export/drawing.h"

namespace toile {

/// What whoever takes a drawing to the table should know before. Nothing where all is well.

/// Which pieces' cut lines share area on the page, and what helps, in one note.
/// Cost: as `overlappingOutlines`. Pure.
std::vector<Wording> overlapNotes(const Pattern& pattern, const Drawing& drawing);
/// Which pieces are drawn without a grain line, since their grain is not stated, in one note. Pure.
std::vector<Wording> grainNotes(const Pattern& pattern, const Drawing& drawing);

}  // namespace toile
