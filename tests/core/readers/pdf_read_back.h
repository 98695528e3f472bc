// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/formats/drawing/drawing.h"
#include "core/formats/export_options.h"
#include "core/formats/read_back.h"

namespace toile {

/// Reads a PDF file again and compares it with what it shows: every line (`comparedWithDrawing`),
/// the size of the pages, their scale, that together they show all of the drawing, the two squares,
/// and the layers.
/// Errors: NotReadBack. Cost: linear in the lines, and their points by the pages. Pure.
Result<ReadBack> readBackPdf(std::string_view bytes, const Drawing& drawing,
                             const PdfOptions& options);

}  // namespace toile
