// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/prove/rest_pattern.h"

// For the sources of this folder only.
namespace toile::prove {

/// The pieces of a file beside ours: which is which, which way each lies, and what is wrong with
/// them. A pair that the file draws once serves both.  Cost: that of `matchPatterns`. Pure.
RestPattern restOfFile(const ExportSource& source, const PatternFile& file);

}  // namespace toile::prove
