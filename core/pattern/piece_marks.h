// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/pattern/grain_line.h"
#include "core/pattern/label.h"
#include "core/pattern/pattern.h"
#include "core/pattern/placement.h"

namespace toile {

/// What a drawing says, in the language of whoever reads it. "%1" stands for how many are cut.
struct DrawingWords {
    std::string noAllowance = "seam line, no allowance";
    std::string mirrored = "mirrored: wrong side of the fabric up";
    std::string cut = "cut %1", cutPair = "cut 1 pair", cutPairs = "cut %1 pairs";
    std::string checkSquare = "check square 100 mm x 100 mm";
    std::string cutOnFold = "cut %1 on fold", placeOnFold = "place on fold";
};

/// What stands on a piece that is not cut once as it is: "cut 3", "cut 2 pairs" where each of them
/// is cut mirrored too, or is drawn for its image as well, "cut 1 on fold". Empty for a single
/// piece.
std::string cuttingNote(const Cutting& cutting, const DrawingWords& words = {},
                        CutAs cutAs = CutAs::Whole);

/// The label of a piece, line by line: its name, how often it is cut, what kind of outline it is
/// and, where it is mirrored, that the wrong side is up.
std::vector<std::string> labelLines(const std::string& name, const Cutting& cutting, bool mirrored,
                                    const DrawingWords& words, CutAs cutAs = CutAs::Whole);

/// What is drawn on a piece as it lies, in files and on screen alike: in sheet directions, about
/// the placement's offset.
struct PieceMarks {
    LabelPlace label{};
    std::optional<Chord> grain{};  ///< none where no line has room
};

/// Places the label (`placeLabel`) and the grain line beside it, or through it where there is no
/// room beside it.
/// @param piece  that is flat  @param grain  direction of the warp, radians, on the piece
/// Cost: that of `placeLabel` and `grainLine`. Pure.
PieceMarks placeMarks(const PatternPiece& piece, const Placement& placement,
                      const std::vector<std::string>& lines, double grain);

/// What a sewer needs to find a seam's other side: a tick at both ends, from the outline into the
/// cloth, and the seam's number and name at its middle, along the edge; the number alone where the
/// name is longer than the edge, nothing where it could not be read. Both sides carry the same.
struct SeamMark {
    int number = 0;
    bool second = false;                        ///< a piece sewn to itself has two with one number
    std::array<std::optional<Chord>, 2> ticks;  ///< none where the seam before ends, straight on
    std::string text;                           ///< empty: none
    LabelPlace place{};                         ///< the text's middle
    double angle = 0;                           ///< of the text, radians, never upside down
};

/// The marks of a piece's seams, by number; free edges have none. Linear. Pure.
std::vector<SeamMark> seamMarks(const PatternPiece& piece, const Placement& placement);

/// The sign of a half pattern: a bracket with two arrow heads on the edge that lies on the fold, as
/// one open path, and words beside it. In sheet directions, about the placement's offset.
struct FoldMark {
    Points2 path;
    LabelPlace place;  ///< of the words' middle
    double angle = 0;  ///< of the words, radians, never upside down
};

/// @param piece  that is cut on the fold  Cost: constant. Pure.
FoldMark foldMark(const PatternPiece& piece, const Placement& placement, const std::string& words);

}  // namespace toile
