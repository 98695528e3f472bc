// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/pattern/pattern.h"
#include "core/reading/line_fit.h"
#include "core/reading/pattern_file.h"

namespace toile {

/// Which piece of a pattern file is which of ours, and how far their lines differ.

enum class MatchedBy { Id, Name, Shape };
/// "id", "name", "shape".
std::string_view name(MatchedBy by);

/// A name by which pieces are paired: its letters and digits in lower case.
std::string plainName(std::string_view name);

enum class MatchedLine { Cut, Seam };

/// Two lines of a pair, one laid over the other.
struct LineMatch {
    MatchedLine ours = MatchedLine::Seam, theirs = MatchedLine::Seam;
    LineFit fit{};                            ///< `laid` is the file's line on our piece
    double lengthOurs = 0, lengthTheirs = 0;  ///< mm
    double areaOurs = 0, areaTheirs = 0;      ///< mm2
};

struct PieceMatch {
    int piece = -1;      ///< index into Pattern::pieces
    int filePiece = -1;  ///< index into PatternFile::pieces
    MatchedBy by = MatchedBy::Shape;
    /// One, or seam line and cutting line where both have both.
    std::vector<LineMatch> lines{};
    /// Others of the file that fit about as well, where it was found by its shape.
    std::vector<int> rivals{};
};

struct PatternMatch {
    std::vector<PieceMatch> pairs{};  ///< in the order of our pieces
    std::vector<int> alone{};         ///< of our flat pieces, those without a partner
    std::vector<int> aloneInFile{};   ///< of the file's pieces of its sample size
};

/// Pieces are paired by the file's id (our slug or id), else by name, case and punctuation aside,
/// else by shape, mirrored where that fits better, the best fit first. A file of several sizes is
/// taken in its sample size (`sampleOf`).
/// @param pattern  whole
/// Cost: pairs by shape times `roughDistance`, and `fitLine` for each pair. Pure.
PatternMatch matchPatterns(const Pattern& pattern, const PatternFile& file);

}  // namespace toile
