// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/formats/drawing/drawing.h"
#include "core/formats/export_options.h"
#include "core/formats/read_back.h"
#include "tests/core/readers/plt_reader.h"

namespace toile {

/// The lines of one of our plots as those of a drawing. A plot names none: pens and their order
/// say which they are.
ReadDrawing drawingOf(const std::vector<PltLine>& plot, const Drawing& drawing,
                      const PltOptions& options);

/// Reads a plot and compares every line that is no letter with the drawing; that nothing is off the
/// page. Errors: NotReadBack. Cost: linear in the points, times the pieces. Pure.
Result<ReadBack> readBackPlt(std::string_view bytes, const Drawing& drawing,
                             const PltOptions& options);

}  // namespace toile
