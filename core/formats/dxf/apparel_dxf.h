// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/wording.h"
#include "core/formats/dxf/apparel_pieces.h"
#include "core/formats/export_source.h"

namespace toile {

/// Texts that describe a style and its pieces for pattern programs: "Key: value", ASCII. An unknown
/// value is left empty, because some programs refuse a file with missing keys.

/// "Piece Name" to "Size", and "Fold" for a piece on the fold. The quantity is "right,left": as in
/// the drawing, and mirrored.
std::vector<std::string> pieceTexts(const ExportSource& source, const DrawnBlock& block,
                                    const std::string& name);
/// Of the control piece.
std::vector<std::string> controlTexts(const ExportSource& source);

/// "Style Name" to the version of the standard. The date is that of the labels, so the same pattern
/// gives the same bytes.
std::vector<std::string> styleTexts(const ExportSource& source);

/// A table of grade rules (.rul) with one size, as named in the style's texts.
std::string writeRuleTable(const ExportSource& source);

/// Lists pieces whose names a DXF file cannot hold, each with its name there, in one note.
/// Cost: linear. Pure.
std::vector<Wording> renamedNotes(const ExportSource& source);

/// DXF R12 ASCII for pattern programs, in the profiles Astm (ASTM D6673) and Aama (ANSI/AAMA-292):
/// an empty HEADER and no TABLES, as AccuMark requires, one BLOCK for each piece, inserted at 0,0,
/// in drawing coordinates; y up, CRLF, printable ASCII. Layers by number (apparel_pieces.h):
/// - 1 cutting line, 14 seam line if it differs, 11 holes, 8 internal lines, fold lines and legs of
///   darts, as POLYLINEs of key points. A POINT on 2 (turn) or 3 (curve) repeats each key point
///   digit by digit. Astm has the dense line after each on 84, 87, 86 and 85, from the same first
///   vertex on, including the key points.
/// - Notches as POINTs with depth (30) and angle into the piece (50): V with its width (39) and
///   slit on 4; T and castle, with their width, on 80 and 81. Aama lacks these two layers and uses
///   slits instead.
/// - 13 drill holes with their diameter (30), 7 grain line, 6 mirror line, 15 label.
/// - System text on 1 (apparel_text.h).
/// @param source  its options set profile, unit and control piece
/// Cost: that of `apparelPieces`, and linear in the points. Pure.
std::string writeApparelDxf(const ExportSource& source);

}  // namespace toile
