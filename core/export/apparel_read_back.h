// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <utility>

#include "core/base/result.h"
#include "core/export/export_source.h"
#include "core/export/read_back.h"
#include "core/reading/dxf_drawing.h"

namespace toile {

/// What `readDxfBack` does of the profiles Astm and Aama.
Result<ReadBack> readApparelBack(const DxfDrawing& read, const ExportSource& source);

/// Coordinates as they were read, mm.
using ReadPlaces = std::set<std::pair<double, double>>;

/// Whether a line that was read has every point of a drawn one in its order, to
/// kReadBackCoordinates, a closed one from any point on, and none besides but those of `others`.
/// Cost: linear. Pure.
bool hasEveryPoint(const Points2& read, const DrawnPath& path, const ReadPlaces& others);

}  // namespace toile
