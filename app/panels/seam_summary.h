// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "core/garment/seam.h"
#include "core/seam/seam_measure.h"

namespace toile {

/// One line about all seams, free edges left out: "26 seams · worst 0.00 mm", "26 seams · 3 do not
/// match · worst 4.20 mm". Empty where there is no seam.
/// @param measures one per seam of the graph; none where a side is not flat
QString seamSummary(const SeamGraph& graph,
                    const std::vector<std::optional<SeamMeasure>>& measures);

}  // namespace toile
