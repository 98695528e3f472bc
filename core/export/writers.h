// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"
#include "core/export/drawing.h"
#include "core/export/export_options.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/layout/marker.h"
#include "core/symmetry/symmetry.h"

namespace toile {

struct ReadBack;

/// Each writer makes the whole file as bytes; the same input gives the same bytes. Numbers never
/// follow the user's locale.

/// Of a millimetre, in drawings.
inline constexpr int kDrawingDecimals = 4;

/// SVG at true scale: page, viewBox and every number in one unit (millimetres; points where the
/// program asks for them), one layer per kind or one group per piece with such layers in it, closed
/// paths ending in Z, ids kept; no transforms but of the names along seams. 4 decimals. Paths name
/// their piece (data-piece), and the layer "seams" has the sides of the seams, not to be seen, with
/// data-seam, data-pair and data-length-3d (mm) but for machines, which would follow them. Letters
/// as outlines keep their text as data-text. Cost: linear in the points.
std::string writeSvg(const Drawing& drawing, const SvgOptions& options = {});

/// DXF R12 ASCII, profile "plain": LTYPE and LAYER tables, no blocks, POLYLINEs, closed but for
/// ticks and grain lines, on named coloured layers (CUT, MARKS, TEXT, CHECK, and SEW, NOTCHES,
/// INTERNAL and GRAIN where there is something on them), y up, CRLF. In `unit`, which $INSUNITS
/// names; 4 decimals of a millimetre. Texts become ASCII.
std::string writePlainDxf(const Drawing& drawing, LengthUnit unit = LengthUnit::Millimetre);

/// The input again as OBJ with the pattern as its UV map: `v` lines with the file's own digits,
/// faces in file order, polygons kept, one `vt` per (piece, vertex) in mm (shortest digits that
/// read back exactly), faces of failed pieces without `vt`, `g` naming the piece. With several
/// files, their vertices follow each other. Comments at the head list what differs from the input.
/// @param results     one per piece of the garment, in its order
/// @param marker      where the flat points go; of mirrored ones the
///                    triangles are clockwise in the UV map, and a comment says so
/// Cost: linear; about a third of a second per million triangles.
std::string writeObj(const Garment& garment, const PieceResults& results, const Marker& marker);
/// What is added to the outlines of a pattern, to stand behind such a file: one object for each of
/// the layers of the cutting lines, seam lines, notches and internal lines, of `v` and `l` lines
/// in the plane z = 0, where the UV map lies.
/// @param drawing  of the same marker  @param unit  of the file, mm  Cost: linear.
std::string writeObjLines(const Drawing& drawing, double unit);
/// The JSON report of docs/report.md. Never NaN or Infinity: null.
/// @param pattern   as it is cut (`asCut`): says how, and how often; without pieces: once
/// @param own       the garment's fabric
std::string writeReport(const Garment& garment, const PieceResults& results,
                        const Pattern& pattern = {}, const Fabric& own = fabricPresets().front());

/// Compares a report with the lengths it was made from: of each outline and each side of a seam.
/// Errors: NotReadBack. Cost: linear. Pure.
Result<ReadBack> readBackReport(const std::string& bytes, const Garment& garment,
                                const PieceResults& results);

/// What a garment holds before it is flat: files, pieces, cuts, seams and problems, as JSON.
std::string writeInfo(const Garment& garment);

}  // namespace toile
