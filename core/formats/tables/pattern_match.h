// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/formats/pattern_file.h"
#include "core/mesh/mesh_arrays.h"
#include "core/pattern/pattern.h"

namespace toile {

/// Fits one closed line onto another without known correspondences.

/// The best rigid motion found that fits a line onto another: a rotation and translation, after a
/// mirroring if allowed.
struct LineFit {
    Points2 laid = Points2(0, 2);  ///< the second line after the motion
    bool mirrored = false;
    double mean = 0;      ///< mm, of the distances of both lines' points from the other line
    double farthest = 0;  ///< mm, the largest of them
    double rms = 0;       ///< mm, root mean square of them
};

/// A rough distance of two closed lines, for sorting: root mean square distance, mm, of points at
/// equal fractions of the lengths, with the best start point and rigid motion. Infinite if a line
/// has fewer than three points or no length.
/// Cost: constant, some 30 thousand steps. Pure.
double roughDistance(const Points2& line, const Points2& other, bool mirrored);

/// Starts like `roughDistance`, then refines by iterative closest points. Uses the mirrored fit
/// only if it is clearly better. Resamples lines of more than 20 000 points at equal distances.
/// @param canMirror  whether mirroring is allowed
/// Cost: up to forty rounds per fit, of n log n in the points of both lines. Pure.
LineFit fitLine(const Points2& line, const Points2& other, bool canMirror = true);

/// Matches the pieces of a pattern file to those of Toile, and compares their lines.

enum class MatchedBy { Id, Name, Shape };
/// "id", "name", "shape".
std::string_view name(MatchedBy by);

/// Name for matching: letters and digits only, in lower case.
std::string plainName(std::string_view name);

enum class MatchedLine { Cut, Seam };

/// Two lines of a pair, one fitted onto the other.
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
    /// One line, or seam line and cutting line if both pieces have both.
    std::vector<LineMatch> lines{};
    /// If matched by shape: other pieces of the file that fit about as well.
    std::vector<int> rivals{};

    /// Whether the pieces may not be the same: there are rivals, or length, area or shape differ by
    /// more than flattening the same piece in two ways explains.
    bool isDoubtful() const;
};

struct PatternMatch {
    std::vector<PieceMatch> pairs{};  ///< in the order of our pieces
    std::vector<int> alone{};         ///< our flat pieces without a match
    std::vector<int> aloneInFile{};   ///< unmatched pieces of the file's sample size
};

/// Matches pieces by the file's id (our slug or id), else by name, ignoring case and punctuation,
/// else by shape, best fit first, mirrored if that fits better. Shapes whose lengths differ by more
/// than 15 % or areas by more than 25 % do not match. Uses only the sample size
/// (`sampleOf`) of a file with several sizes.
/// @param pattern  with whole pieces, not halves on the fold
/// Cost: pairs by shape times `roughDistance`, and `fitLine` for each pair. Pure.
PatternMatch matchPatterns(const Pattern& pattern, const PatternFile& file);

}  // namespace toile
