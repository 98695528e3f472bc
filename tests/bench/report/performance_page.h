// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/bench/report/measurements.h"

namespace toile::bench {

/// docs/performance.md: every table of it from the figures of one run. What the run has no figures
/// for is left out.
std::string performancePage(const Measurements& run);

}  // namespace toile::bench
