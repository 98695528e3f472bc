// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"
#include "core/flatten/base/piece_result.h"
#include "core/formats/drawing/drawing.h"
#include "core/formats/export_options.h"
#include "core/garment/garment.h"
#include "core/layout/marker.h"
#include "core/symmetry/symmetry.h"

namespace toile {

struct ReadBack;

/// Each writer returns the whole file as bytes; the same input gives the same bytes. Numbers do not
/// depend on the user's locale.

/// Decimals of a millimetre in drawings.
inline constexpr int kDrawingDecimals = 4;

/// SVG at true scale: page, viewBox and every number in one unit (millimetres; points for programs
/// that require them), one layer per kind or one group per piece with such layers in it, closed
/// paths ending in Z, ids kept; no transforms except for the names along seams. 4 decimals. Paths
/// name their piece (data-piece). The layer "seams" has the sides of the seams, invisible, with
/// data-seam, data-pair and data-length-3d (mm), except for machines, which would follow them.
/// Letters as outlines keep their text as data-text. Cost: linear in the points.
std::string writeSvg(const Drawing& drawing, const SvgOptions& options = {});

/// DXF R12 ASCII, profile "plain": LTYPE and LAYER tables, no blocks, POLYLINEs, closed except for
/// ticks and grain lines, on named coloured layers (CUT, MARKS, TEXT, CHECK, and SEW, NOTCHES,
/// INTERNAL and GRAIN if they have content), y up, CRLF. In `unit`, as stated in $INSUNITS; 4
/// decimals of a millimetre. Texts become ASCII.
std::string writePlainDxf(const Drawing& drawing, LengthUnit unit = LengthUnit::Millimetre);

/// The input as OBJ with the pattern as its UV map: `v` lines with the file's own digits, faces in
/// file order, polygons kept, one `vt` per (piece, vertex) in mm (shortest digits that read back
/// exactly), faces of failed pieces without `vt`, `g` naming the piece. With several files, their
/// vertices follow each other. Comments at the head list the differences from the input.
/// @param results     one per piece of the garment, in its order
/// @param marker      places of the flat points; triangles of mirrored ones are clockwise in the UV
/// map, as stated in a comment
/// Cost: linear; about a third of a second per million triangles.
std::string writeObj(const Garment& garment, const PieceResults& results, const Marker& marker);
/// Additions to the outlines of a pattern, for the end of such a file: one object for each of the
/// layers of the cutting lines, seam lines, notches and internal lines, of `v` and `l` lines in the
/// plane z = 0, as the UV map.
/// @param drawing  of the same marker  @param unit  of the file, mm  Cost: linear.
std::string writeObjLines(const Drawing& drawing, double unit);
/// The JSON report of docs/report.md. Never NaN or Infinity: null.
/// @param pattern   as cut (`asCut`): how each piece is cut, and how often; without pieces: once
/// @param own       the garment's fabric
std::string writeReport(const Garment& garment, const PieceResults& results,
                        const Pattern& pattern = {}, const Fabric& own = fabricPresets().front());

/// Compares a report with its source lengths: of each outline and each side of a seam.
/// Errors: NotReadBack. Cost: linear. Pure.
Result<ReadBack> readBackReport(const std::string& bytes, const Garment& garment,
                                const PieceResults& results);

/// A garment before flattening: files, pieces, cuts, seams and problems, as JSON.
std::string writeInfo(const Garment& garment);

}  // namespace toile
