// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/formats/drawing/drawing.h"
#include "core/formats/export_options.h"
#include "core/formats/read_back.h"
#include "core/formats/svg/svg_reader.h"

namespace toile {

/// The lines of one of our SVG files as lines of a drawing, by the names of its layers; without
/// letters and sides of seams. Pure.
ReadDrawing drawingOf(const ReadSvg& svg);

/// Reads an SVG file and compares its page, its lines with their layers, and the sides of its seams
/// with their source. Errors: NotReadBack. Cost: linear in the points. Pure.
Result<ReadBack> readBackSvg(std::string_view bytes, const Drawing& drawing,
                             const SvgOptions& options);

}  // namespace toile
