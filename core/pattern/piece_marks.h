// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geometry/placement.h"
#include "core/pattern/label.h"
#include "core/pattern/pattern.h"
#include "core/pattern/piece_grain.h"
#include "core/pattern/seam_marks.h"

namespace toile {

/// Texts of a drawing and its printed sheets, in the reader's language. "%1" and "%2" stand for
/// numbers.
struct DrawingWords {
    std::string noAllowance = "seam line, no allowance";
    std::string mirrored = "mirrored: wrong side of the fabric up";
    std::string cut = "cut %1", cutPair = "cut 1 pair", cutPairs = "cut %1 pairs";
    std::string checkSquare = "check square 100 mm x 100 mm";
    std::string cutOnFold = "cut %1 on fold", placeOnFold = "place on fold";
    std::string pieceNumber = "piece %1 of %2", size = "size %1";
    std::string allowance = "seam allowance included";
    std::string pages = "pieces: %1, pages after this one: %2", page = "page %1 of %2";
    /// On the first page of tiles, line by line.
    std::string printing =
        "Print at 100 % (actual size),\nnot fitted to the page.\nMeasure both squares first.";
    std::string joining =
        "Cut along the grey frames where pages\nmeet, and join them by their marks:\n"
        "the halves make whole diamonds.";
};

/// Contents of a label besides the name and the cutting note; empty or 0 is not written.
struct LabelFacts {
    int number = 0;  ///< PatternPiece::number
    int count = 0;   ///< of drawn pieces (`drawnCount`)
    std::string size{}, material{}, date{};
    bool hasAllowance = false;  ///< else the label says that the line is the seam line,
    bool isDrawnOut = false;    ///< unless it has extensions
};

/// Cutting note of a piece: "cut 3"; "cut 2 pairs" if each copy is also cut mirrored, or represents
/// its image; "cut 1 on fold". Empty for a single piece.
std::string cuttingNote(const Cutting& cutting, const DrawingWords& words = {},
                        CutAs cutAs = CutAs::Whole);

/// The label of a piece, line by line: its name, number, size and material, its cutting note,
/// whether an allowance is included, the date and, if it is mirrored, that the wrong side is up.
std::vector<std::string> labelLines(const std::string& name, const Cutting& cutting, bool mirrored,
                                    const DrawingWords& words, CutAs cutAs = CutAs::Whole,
                                    const LabelFacts& facts = {});

/// Longest user text on labels, characters; the rest is cut off.
inline constexpr std::size_t kMaxLabelText = 40;

/// The user's texts; for a pattern with allowances all known facts.
LabelFacts factsOf(const Pattern& pattern, const PatternPiece& piece);

/// How many pieces and facings of a pattern have an outline: the "12" of "piece 3 of 12".
int drawnCount(const Pattern& pattern);

/// The marks drawn on a placed piece, in files and on screen alike: in sheet directions, relative
/// to the placement's offset.
struct PieceMarks {
    LabelPlace label{};
    std::vector<std::string> lines{};  ///< of the label
    std::optional<Chord> grain{};      ///< empty if no line fits
    std::vector<SeamMark> seams{};
};

/// Lines on the cloth besides seam marks, label and grain line: notches, internal lines and, if the
/// pattern has allowances, the marks of darts.
std::vector<Points2> drawnOnCloth(const Pattern& pattern, const PatternPiece& piece);

/// Places the marks of the seams (`seamMarks`), then the label (`placeLabel`) and the grain line
/// (`grainLine`) side by side in the remaining room. If a label does not fit, its lines are broken
/// in two (`brokenLines`) if that helps. A piece of less than 1 cm² has neither label nor grain
/// line.
/// @param piece      a flat piece  @param grain  warp direction, radians, on the piece
/// @param obstacles  `drawnOnCloth`, on the piece; the mark of a fold is added
/// Cost: that of these four. Pure.
PieceMarks placeMarks(const PatternPiece& piece, const Placement& placement,
                      const std::vector<std::string>& lines, double grain,
                      const std::vector<Points2>& obstacles = {});

/// The fold mark of a half pattern: a bracket with two arrow heads on the fold edge, as a single
/// open path, and words next to it. In sheet directions, relative to the placement's offset.
struct FoldMark {
    Points2 path;
    LabelPlace place;  ///< of the words' middle
    double angle = 0;  ///< of the words, radians, never upside down
};

/// @param piece  cut on the fold  Cost: constant. Pure.
FoldMark foldMark(const PatternPiece& piece, const Placement& placement, const std::string& words);

}  // namespace toile
