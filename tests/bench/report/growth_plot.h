// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/bench/report/measurements.h"

namespace toile::bench {

/// The times of the floor, our methods and the peers over the number of triangles, both axes
/// logarithmic, one field per surface, as a picture in SVG that is legible on light and dark
/// pages. Series are told apart by colours that the colour-blind can tell apart, by the shapes of
/// their points and by names at their ends.
std::string growthPlot(const Measurements& run);

}  // namespace toile::bench
