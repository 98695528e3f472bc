// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/report/markdown.h"
#include "tests/bench/report/measurements.h"

namespace toile::bench {

/// Tables of performance.md about pieces in memory, a row per piece of which there are figures.
MarkdownTable floorTable(const Measurements& run);  ///< every candidate and the winner's name
MarkdownTable timeTable(const Measurements& run);   ///< our methods, times and times the floor
MarkdownTable peerTable(const Measurements& run);   ///< CGAL's, times ours, and energies

}  // namespace toile::bench
