// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "core/garment/seam.h"
#include "core/seam/seam_measure.h"

class QPainter;

namespace toile::app {

/// "matches", "nearly", "does not match"; empty where unknown.
QString fitWord(SeamFit fit);
/// Green, amber, red; told apart by lightness too. Invalid where unknown.
QColor fitColour(SeamFit fit);
/// A picture of 32 pixels in its own colours, also in a selected row.
QIcon paintedMark(const std::function<void(QPainter&)>& paint);
/// A disc with a tick, a triangle with an exclamation mark, a square with a cross.
QIcon fitMark(SeamFit fit);

/// One line about all seams, free edges left out: "26 seams · worst 0.00 mm", "26 seams · 3 do not
/// match · worst 4.20 mm". Empty where there is no seam.
/// @param measures one per seam of the graph; none where a side is not flat
QString seamSummary(const SeamGraph& graph,
                    const std::vector<std::optional<SeamMeasure>>& measures);

}  // namespace toile::app
