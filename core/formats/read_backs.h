// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/formats/drawing/drawing.h"
#include "core/formats/export_options.h"
#include "core/formats/export_source.h"
#include "core/formats/formats.h"
#include "core/formats/mesh/piece_meshes.h"
#include "core/formats/read_back.h"
#include "core/formats/svg/svg_reader.h"

namespace toile {

/// Reads a DXF file of any profile (core/formats) and compares it with its source. All profiles:
/// each line with the drawing's (`comparedWithDrawing`), point by point, and the unit. Astm and
/// Aama also: one block for each piece, each inserted at 0,0; the polygons of key points alone;
/// each key point, and no other point, is a record on 2 or 3; system texts; grain and mirror line;
/// notches, which are on the cutting line and end in the drawn mark; drill holes; the sides of the
/// control piece; the rule table.
/// Errors: NotReadBack, with the line or piece. Cost: linear in the points. Pure.
Result<ReadBack> readDxfBack(const ExportedFiles& files, const ExportSource& source);

/// The lines of one of our SVG files as lines of a drawing, by the names of its layers; without
/// letters and sides of seams. Pure.
ReadDrawing drawingOf(const ReadSvg& svg);

/// Reads an SVG file and compares its page, its lines with their layers, and the sides of its seams
/// with their source. Errors: NotReadBack. Cost: linear in the points. Pure.
Result<ReadBack> readBackSvg(std::string_view bytes, const Drawing& drawing,
                             const SvgOptions& options);

/// Compares an OBJ file of the whole garment (`writeObj`), whose polygons are the input's, with its
/// source: every point of the pattern within kReadBackCoordinates, both sides of each seam in
/// length within kReadBackLengths. Errors: NotReadBack. Cost: linear. Pure.
Result<ReadBack> comparedWithObj(const std::string& obj, const ExportSource& source);

/// Compares the lengths of both sides of each seam in a read pattern; adds this to `found`.
/// @param uv        #V x 2 of each mesh, mm
/// @param rounding  mm of error between two vertices by the format's rounding
Result<ReadBack> withSeamsCompared(ReadBack found, const PieceMeshes& meshes,
                                   const std::vector<Points2>& uv, double rounding = 0);

/// Reads the size of a PNG picture, in dots and dots per metre, and checks that every chunk is
/// whole and the last is there. The image itself is not checked. Errors: NotReadBack. Cost: linear
/// in the bytes. Pure.
Result<ReadBack> readBackPng(std::string_view bytes, const Drawing& drawing,
                             const PngOptions& options);

}  // namespace toile
