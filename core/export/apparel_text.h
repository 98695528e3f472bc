// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/export/apparel_pieces.h"

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

}  // namespace toile
