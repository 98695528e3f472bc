// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/export/export_source.h"
#include "core/export/formats.h"
#include "core/export/read_back.h"

namespace toile {

/// Reads a DXF file of any profile again (core/reading) and compares it with what it was made from.
/// Of all profiles: each line with the drawing's (`comparedWithDrawing`), point by point, and the
/// unit. Of Astm and Aama besides: one block for each piece, each inserted at 0,0; the polygons of
/// key points by themselves; each key point is a record on 2 or 3, and only they are; system texts;
/// grain and mirror line; notches, which lie on the line that is cut and end in the drawn mark;
/// drill holes; the sides of the control piece; the rule table beside it.
/// Errors: NotReadBack, with the line or piece. Cost: linear in the points. Pure.
Result<ReadBack> readDxfBack(const ExportedFiles& files, const ExportSource& source);

}  // namespace toile
