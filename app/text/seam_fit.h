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

/// "matches", "nearly", "does not match"; empty if unknown.
QString fitWord(SeamFit fit);
/// Green, amber, red; also different in lightness. Invalid if unknown.
QColor fitColour(SeamFit fit);
/// A 32-pixel icon that keeps its colours in a selected row.
QIcon paintedMark(const std::function<void(QPainter&)>& paint);
/// A disc with a tick, a triangle with an exclamation mark, a square with a cross.
QIcon fitMark(SeamFit fit);

/// One line about all seams, without free edges: "26 seams · worst 0.00 mm", "26 seams · 3 do not
/// match · worst 4.20 mm". Empty without seams.
/// @param measures one per seam of the graph; nullopt if a side is not flat
QString seamSummary(const SeamGraph& graph,
                    const std::vector<std::optional<SeamMeasure>>& measures);

}  // namespace toile::app
