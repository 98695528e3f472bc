// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/formats/export_source.h"
#include "core/formats/formats.h"
#include "core/formats/read_back.h"

namespace toile {

/// Reads a DXF file of any profile (core/formats) and compares it with its source. All profiles:
/// each line with the drawing's (`comparedWithDrawing`), point by point, and the unit. Astm and
/// Aama also: one block for each piece, each inserted at 0,0; the polygons of key points alone;
/// each key point, and no other point, is a record on 2 or 3; system texts; grain and mirror line;
/// notches, which are on the cutting line and end in the drawn mark; drill holes; the sides of the
/// control piece; the rule table.
/// Errors: NotReadBack, with the line or piece. Cost: linear in the points. Pure.
Result<ReadBack> readDxfBack(const ExportedFiles& files, const ExportSource& source);

}  // namespace toile
