// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/report/markdown.h"
#include "tests/bench/report/measurements.h"

namespace toile::bench {

/// Tables of performance.md about the pipeline from file to files.
MarkdownTable endToEndTable(const Measurements& run);  ///< a row per garment and method
MarkdownTable stageTable(const Measurements& run);     ///< of a million triangles, a row per stage

}  // namespace toile::bench
