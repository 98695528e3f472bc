// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/export/apparel_pieces.h"

namespace toile {

/// The texts by which pattern programs know a style and its pieces: "Key: value", ASCII. A value
/// that nobody has stated is left empty, for keys that are missing make some programs refuse a
/// file.

/// "Piece Name" to "Size", and "Fold" of a piece on the fold. Its quantity is "right,left": as it
/// lies in the drawing, and as its image.
std::vector<std::string> pieceTexts(const ExportSource& source, const DrawnBlock& block,
                                    const std::string& name);
/// Of the control piece.
std::vector<std::string> controlTexts(const ExportSource& source);

/// "Style Name" to the version of the standard. The date is the one that labels have, so that the
/// same pattern gives the same bytes.
std::vector<std::string> styleTexts(const ExportSource& source);

/// A table of grade rules (.rul) with one size, as the texts of the style name it.
std::string writeRuleTable(const ExportSource& source);

}  // namespace toile
